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

-- A formula alone has no name that a screen reader could say for the whole row.
local function has_words(cell)
  local inlines = cell.content[1] and cell.content[1].content
  return not (#cell.content == 1 and #inlines == 1 and (inlines[1].t == "Math" or inlines[1].t == "Para"))
end

-- Roles of elements that are laid out as blocks where there is no room for a table: browsers may take them for
-- such then.
local roles = { table = "table", thead = "rowgroup", tbody = "rowgroup", tr = "row", td = "cell" }
local roles_of_heads = { col = "columnheader", row = "rowheader" }

local function with_role(tag, role, is_stacking)
  return tag .. (is_stacking and (' role="' .. role .. '"') or "")
end

-- What a table is made of: how its cells are aligned, which column names the rows, and the names of all columns.
local function layout(div)
  local alignments = {}
  for alignment in div.attributes.align:gmatch("%S+") do
    table.insert(alignments, alignment)
  end
  return {
    alignments = alignments,
    header_column = tonumber(div.attributes["header-column"] or "1"),
    is_stacking = div.classes:includes("stacking"),
    names = div.content[1].content:map(pandoc.utils.stringify),
  }
end

local function cell_tag(cell, position, is_head, layout)
  local scope = is_head and "col" or position == layout.header_column and has_words(cell) and "row"
  if scope then
    return "th", with_role("th", roles_of_heads[scope], layout.is_stacking) .. ' scope="' .. scope .. '"'
  end
  local opening = with_role("td", roles.td, layout.is_stacking)
  if layout.is_stacking and position ~= layout.header_column then
    opening = opening .. ' data-column="' .. escaped(layout.names[position]) .. '"'
  end
  return "td", opening
end

local function table_row(row, is_head, layout)
  local opening = with_role("tr", roles.tr, layout.is_stacking)
  local result = pandoc.List({ raw("<" .. opening .. ' class="' .. table.concat(row.classes, " ") .. '">') })
  for position, cell in ipairs(row.content) do
    local tag, attributes = cell_tag(cell, position, is_head, layout)
    local class = ' class="' .. layout.alignments[position] .. '">'
    result:extend(wrapped("<" .. attributes .. class, cell_blocks(cell), "</" .. tag .. ">"))
  end
  result:insert(raw("</tr>"))
  return result
end

local function report_table(div)
  local layout = layout(div)
  local opening = '<div class="table-box" role="region" tabindex="0" aria-label="%s"><%s class="%s">'
  local tag = with_role("table", roles.table, layout.is_stacking)
  local result = pandoc.List({
    raw(opening:format(escaped(div.attributes.label), tag, table.concat(div.classes, " "))),
  })
  for position, row in ipairs(div.content) do
    local is_head = position == 1
    local group = is_head and "thead" or "tbody"
    if position <= 2 then
      result:insert(raw("<" .. with_role(group, roles[group], layout.is_stacking) .. ">"))
    end
    result:extend(table_row(row, is_head, layout))
    if is_head or position == #div.content then
      result:insert(raw("</" .. group .. ">"))
    end
  end
  result:insert(raw("</table></div>"))
  return result
end

-- Formulas that were met since the last disclosure: Divs are met from the inside to the outside.
local sources = {}

local function formula(div)
  table.insert(sources, { name = div.attributes.name, latex = div.content[1].content[1].text })
  div.attributes.name = nil
  return div
end

-- One disclosure with the LaTeX of these formulas.
local function latex_sources()
  if #sources == 0 then
    return {}
  end
  local html = { '<details class="latex"><summary>LaTeX</summary>' }
  for _, source in ipairs(sources) do
    local entry = '<figure class="source"><figcaption>%s</figcaption><pre tabindex="0"><code>%s</code></pre></figure>'
    table.insert(html, entry:format((escaped(source.name):gsub("(%d) (%a)", "%1\u{a0}%2")), escaped(source.latex)))
  end
  table.insert(html, "</details>")
  sources = {}
  return { raw(table.concat(html)) }
end

local function equation(div)
  local result = pandoc.List({ raw('<div class="equation">') })
  result:extend(div.content)
  if (div.attributes.thesis or "") ~= "" then
    result:insert(raw('<span class="thesis-number">(' .. escaped(div.attributes.thesis) .. ")</span>"))
  end
  result:insert(raw("</div>"))
  return result
end

local function claim(div)
  local opening = '<article class="claim" id="%s" data-verdict="%s" data-grade="%s" data-chapter="%s">'
  local attributes = div.attributes
  local blocks = div.content:map(function(block)
    if block.t == "Div" and block.classes:includes("latex-sources") then
      return pandoc.Div(latex_sources())
    end
    return block
  end)
  return wrapped(
    opening:format(escaped(div.identifier), escaped(attributes.verdict), escaped(attributes.grade), escaped(attributes.chapter)),
    blocks,
    "</article>"
  )
end

local function figure(div)
  local opening = '<div class="paper" role="group" tabindex="0" aria-label="%s">'
  return wrapped(
    '<figure class="drawing" id="' .. escaped(div.identifier) .. '">',
    wrapped(opening:format(escaped(div.attributes.label)), { pandoc.Plain(div.content[1].content) }, "</div>")
      .. wrapped("<figcaption>", { table.unpack(div.content, 2) }, "</figcaption>"),
    "</figure>"
  )
end

-- The figure of the first screen has no tools, to leave room for what stands around it.
local function opening_figure(div)
  return wrapped(
    '<figure class="opening-figure">',
    wrapped(
      '<div class="paper" role="group" tabindex="0" aria-label="' .. escaped(div.attributes.label) .. '">',
      { pandoc.Plain(div.content[1].content) }, "</div>"
    )
      .. wrapped("<figcaption>", { table.unpack(div.content, 2) }, "</figcaption>"),
    "</figure>"
  )
end

local function program(div)
  local summary = "<details class=\"program\"><summary>Show the %s lines of %s</summary>"
  local blocks = div.content:map(function(block)
    if block.t ~= "CodeBlock" then
      return block
    end
    local opening = summary:format(escaped(div.attributes.lines), escaped(div.identifier))
    return pandoc.Div({
      raw(opening .. '<pre tabindex="0"><code>' .. escaped(block.text) .. "</code></pre></details>"),
    })
  end)
  blocks[1].identifier = div.identifier
  return blocks
end

local function comparison_side(heading)
  return function(div)
    div.content:insert(1, pandoc.Div({ pandoc.Plain({ pandoc.Str(heading) }) }, { class = "side-heading" }))
    return div
  end
end

-- A side whose heading names the text that is judged.
local function named_side(div)
  local heading = div.attributes.heading
  div.attributes.heading = nil
  return comparison_side(heading)(div)
end

local function section(class)
  return function(div)
    return wrapped('<section class="' .. class .. '">', div.content, "</section>")
  end
end

local function nothing()
  return {}
end

local converters = {
  formula = formula,
  table = report_table,
  equation = equation,
  claim = claim,
  figure = figure,
  program = program,
  printed = named_side,
  derived = comparison_side("As derived"),
  agreed = named_side,
  missing = comparison_side("What is missing"),
  -- A chapter comes in several pieces.
  ["chapter-begin"] = function(div)
    return raw('<section class="chapter" data-chapter="' .. escaped(div.attributes.chapter) .. '">')
  end,
  ["chapter-end"] = function()
    return raw("</section>")
  end,
  group = section("group"),
  ["errata-sheet"] = section("errata-sheet"),
  ["opening-figure"] = opening_figure,
  ["answer-side"] = function(div)
    return comparison_side(div.attributes.side)(pandoc.Div(div.content, { class = "answer-side" }))
  end,
  ["spread-picture"] = function(div)
    return wrapped('<div class="picture">', { pandoc.Plain(div.content[1].content) }, "</div>")
  end,
  ["step-picture"] = function(div)
    local blocks = { pandoc.Plain(div.content[1].content) }
    return wrapped('<figure class="picture" id="' .. escaped(div.identifier) .. '">', blocks, "")
      .. wrapped("<figcaption>", { table.unpack(div.content, 2) }, "</figcaption></figure>")
  end,
  -- The LaTeX of all formulas of a step.
  ["step-sources"] = latex_sources,
  -- The lines of code of a step, each function folded.
  lines = function(div)
    local opening = '<details class="lines"><summary><code>%s</code>, %s</summary><pre tabindex="0"><code>%s</code></pre></details>'
    return raw(opening:format(escaped(div.attributes.name), escaped(div.attributes.place), escaped(div.content[1].text)))
  end,
  fold = function(div)
    local opening = "<details class=\"fold\"><summary>" .. escaped(div.attributes.summary) .. "</summary>"
    return wrapped(opening, div.content, "</details>")
  end,
  outline = nothing,
  ["end-of-report"] = nothing,
  explorable = function()
    return raw('<div class="explorable"></div>')
  end,
  -- Places of what the reader's own copy has: it is put there when the page is finished.
  passage = function(div)
    return raw("<!-- passage " .. escaped(div.attributes.claim) .. " -->")
  end,
  ["reader-copy"] = function()
    return raw("<!-- reader's copy -->")
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

-- How a heading stands on a page concerns print alone.
function Header(header)
  header.classes = header.classes:filter(function(class)
    return class ~= "breaking"
  end)
  return header
end

function Span(span)
  if span.classes:includes("unbroken") then
    return {}
  elseif span.classes:includes("broken") then
    return span.content
  end
end
