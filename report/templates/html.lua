-- Turns the Divs of the report into semantic HTML. The page around it is page.html.j2.

local function raw(text)
  return pandoc.RawBlock("html", text)
end

local function escaped(text)
  local entities = { ["&"] = "&amp;", ["<"] = "&lt;", [">"] = "&gt;", ['"'] = "&quot;" }
  return (text:gsub('[&<>"]', entities))
end

local function wrapped(opening, blocks, closing)
  local result = pandoc.List({ raw(opening) })
  result:extend(blocks)
  result:insert(raw(closing))
  return result
end

-- A cell with a single paragraph needs no <p>.
local function cell_blocks(cell)
  if #cell.content == 1 and cell.content[1].t == "Para" then
    return { pandoc.Plain(cell.content[1].content) }
  end
  return cell.content
end

local function table_row(row, alignments, is_head)
  local result = pandoc.List({ raw('<tr class="' .. table.concat(row.classes, " ") .. '">') })
  for position, cell in ipairs(row.content) do
    local tag, scope = "td", ""
    if is_head then
      tag, scope = "th", ' scope="col"'
    elseif position == 1 then
      tag, scope = "th", ' scope="row"'
    end
    local opening = '<%s%s class="%s">'
    local blocks = cell_blocks(cell)
    result:extend(wrapped(opening:format(tag, scope, alignments[position]), blocks, "</" .. tag .. ">"))
  end
  result:insert(raw("</tr>"))
  return result
end

local function report_table(div)
  local label = escaped(div.attributes.label)
  local opening = '<div class="table-box" role="region" tabindex="0" aria-label="%s"><table class="%s">'
  local result = pandoc.List({ raw(opening:format(label, table.concat(div.classes, " "))) })
  local alignments = {}
  for alignment in div.attributes.align:gmatch("%S+") do
    table.insert(alignments, alignment)
  end
  for position, row in ipairs(div.content) do
    local is_head = position == 1
    local group = is_head and "thead" or "tbody"
    if position <= 2 then
      result:insert(raw("<" .. group .. ">"))
    end
    result:extend(table_row(row, alignments, is_head))
    if is_head or position == #div.content then
      result:insert(raw("</" .. group .. ">"))
    end
  end
  result:insert(raw("</table></div>"))
  return result
end

-- One disclosure with the LaTeX of each formula in the blocks.
local function latex_sources(blocks)
  local sources = {}
  pandoc.Blocks(blocks):walk({
    Div = function(div)
      if div.classes:includes("formula") then
        div:walk({
          Math = function(math)
            table.insert(sources, { name = div.attributes.name, latex = math.text })
          end,
        })
      end
    end,
  })
  if #sources == 0 then
    return {}
  end
  local html = { '<details class="latex"><summary>LaTeX</summary>' }
  for _, source in ipairs(sources) do
    local entry = '<figure class="source"><figcaption>%s</figcaption><pre tabindex="0"><code>%s</code></pre></figure>'
    table.insert(html, entry:format(escaped(source.name), escaped(source.latex)))
  end
  table.insert(html, "</details>")
  return { raw(table.concat(html)) }
end

local function equation(div)
  local result = pandoc.List({ raw('<div class="equation">') })
  result:extend(div.content)
  if (div.attributes.thesis or "") ~= "" then
    result:insert(raw('<span class="thesis-number">(' .. escaped(div.attributes.thesis) .. ")</span>"))
  end
  result:insert(raw("</div>"))
  result:extend(latex_sources(div.content))
  return result
end

local function claim(div)
  local opening = '<article class="claim" id="%s" data-verdict="%s" data-chapter="%s">'
  local attributes = div.attributes
  local blocks = div.content:map(function(block)
    if block.t == "Div" and block.classes:includes("latex-sources") then
      return pandoc.Div(latex_sources(div.content))
    end
    return block
  end)
  return wrapped(
    opening:format(escaped(div.identifier), escaped(attributes.verdict), escaped(attributes.chapter)),
    blocks,
    "</article>"
  )
end

local function figure(div)
  return wrapped(
    '<figure class="drawing" id="' .. escaped(div.identifier) .. '">',
    wrapped('<div class="paper">', { div.content[1] }, "</div>")
      .. wrapped("<figcaption>", { table.unpack(div.content, 2) }, "</figcaption>"),
    "</figure>"
  )
end

local function comparison_side(heading)
  return function(div)
    div.content:insert(1, pandoc.Div({ pandoc.Plain({ pandoc.Str(heading) }) }, { class = "side-heading" }))
    return div
  end
end

local converters = {
  table = report_table,
  equation = equation,
  claim = claim,
  figure = figure,
  printed = comparison_side("As printed"),
  derived = comparison_side("As derived"),
  agreed = comparison_side("As printed and as derived"),
  missing = comparison_side("What is missing"),
  chapter = function(div)
    return wrapped(
      '<section class="chapter" data-chapter="' .. escaped(div.attributes.chapter) .. '">',
      div.content,
      "</section>"
    )
  end,
}

function Div(div)
  for position = #div.classes, 1, -1 do
    local convert = converters[div.classes[position]]
    if convert then
      return convert(div)
    end
  end
end

