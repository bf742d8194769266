-- Turns the Divs of the report into calls of the Typst functions that report.typ defines.

local function raw(text)
  return pandoc.RawBlock("typst", text)
end

local function quoted(text)
  local escaped = (text or ""):gsub("\\", "\\\\"):gsub('"', '\\"')
  return '"' .. escaped .. '"'
end

local function wrapped(opening, blocks, closing)
  local result = pandoc.List({ raw(opening) })
  result:extend(blocks)
  result:insert(raw(closing))
  return result
end

local function call(name)
  return function(div)
    return wrapped("#" .. name .. "[", div.content, "]")
  end
end

local function table_cells(row, result)
  for _, cell in ipairs(row.content) do
    result:extend(wrapped("[", cell.content, "],"))
  end
end

local function array(words)
  return "(" .. words:gsub("%s+", ", ") .. ",)"
end

local function report_table(div)
  local columns, alignments = array(div.attributes.columns), array(div.attributes.align)
  local result = pandoc.List({ raw("#report-table(" .. columns .. ", " .. alignments .. ", (") })
  for position, row in ipairs(div.content) do
    table_cells(row, result)
    if position == 1 then
      result:insert(raw("),"))
    end
  end
  result:insert(raw(")"))
  return result
end

local function claim(div)
  div.content[1].identifier = div.identifier
  return wrapped("#claim(" .. quoted(div.attributes.verdict) .. ")[", div.content, "]")
end

local function figure(div)
  local image = div.content[1].content[1]
  local opening = "#drawing(%s, alt: %s)["
  return wrapped(
    opening:format(quoted(image.src), quoted(pandoc.utils.stringify(image.caption))),
    { table.unpack(div.content, 2) },
    "] <" .. div.identifier .. ">"
  )
end

local headings = {
  printed = "As printed",
  derived = "As derived",
  missing = "What is missing",
  agreed = "As printed and as derived",
}

local converters = {
  table = report_table,
  claim = claim,
  figure = figure,
  chapter = function(div)
    return div.content
  end,
  comparison = function(div)
    local result = pandoc.List({ raw("#comparison(") })
    for _, side in ipairs(div.content) do
      local heading = headings[side.classes[#side.classes]]
      result:extend(wrapped("(" .. quoted(heading) .. ", [", side.content, "]),"))
    end
    result:insert(raw(")"))
    return result
  end,
  formula = function(div)
    return wrapped("#formula(" .. quoted(div.attributes.name) .. ")[", div.content, "]")
  end,
  equation = function(div)
    return wrapped("#numbered(" .. quoted(div.attributes.thesis) .. ")[", div.content, "]")
  end,
  legend = call("legend"),
  judged = call("judged"),
  meta = call("meta"),
  method = call("method"),
  part = call("part"),
  filter = function()
    return {}
  end,
  ["latex-sources"] = function()
    return {}
  end,
}

function Div(div)
  local convert = converters[div.classes[1]]
  if convert then
    return convert(div)
  end
end

function Span(span)
  if span.classes:includes("badge") then
    local result = pandoc.List({ pandoc.RawInline("typst", "#badge(" .. quoted(span.classes[2]) .. ")[") })
    result:extend(span.content)
    result:insert(pandoc.RawInline("typst", "]"))
    return result
  elseif span.classes:includes("file") then
    return pandoc.Code(pandoc.utils.stringify(span.content))
  end
end

-- Typst sets a sign at the start of a line as a prefix, parts the columns of cases by nothing, and takes bars
-- that do not stretch for relations.
function Math(math)
  if not math.text:find("\\left|", 1, true) and not math.text:find("\\|", 1, true) then
    math.text = math.text:gsub("|([^|]+)|", "\\left|%1\\right|")
  end
  math.text = math.text:gsub("(& \\quad [%+%-]) ", "%1 \\: "):gsub("& *\\text{", "& \\quad \\text{")
  return math
end
