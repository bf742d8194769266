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

-- The errata as running text: two columns of a page have no room for three of a table.
local function errata(div)
  local result = pandoc.List({ raw("#errata(") })
  for position, row in ipairs(div.content) do
    if position > 1 then
      result:insert(raw("("))
      table_cells(row, result)
      result:insert(raw("),"))
    end
  end
  result:insert(raw(")"))
  return result
end

local function report_table(div)
  if div.classes:includes("errata") then
    return errata(div)
  end
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
  return wrapped("#claim(" .. quoted(div.attributes.grade) .. ")[", div.content, "]")
end

local function figure(div)
  local image = div.content[1].content[1]
  local opening, closing = "#picture(%s, alt: %s)[", "] <"
  if div.classes:includes("floating") then
    opening, closing = "#floating(picture(%s, alt: %s)[", "]) <"
  end
  return wrapped(
    opening:format(quoted(image.src), quoted(pandoc.utils.stringify(image.caption))),
    { table.unpack(div.content, 2) },
    closing .. div.identifier .. ">"
  )
end

-- The code itself is not set but attached to the PDF.
local function program(div)
  local blocks = div.content:filter(function(block)
    return block.t ~= "CodeBlock"
  end)
  blocks[1].identifier = div.identifier
  blocks:insert(raw("#attached(" .. quoted(div.identifier) .. ", " .. div.attributes.lines .. ")"))
  return blocks
end

local function content(div)
  return div.content
end

local function nothing()
  return {}
end

local function is_text(side)
  return side.content:find_if(function(block)
    return block.t == "Div" and block.classes:includes("formula")
  end) == nil
end

local headings = {
  derived = "As derived",
  missing = "What is missing",
}

local converters = {
  table = report_table,
  claim = claim,
  figure = figure,
  ["step-picture"] = figure,
  ["spread-picture"] = function(div)
    local image = div.content[1].content[1]
    local opening = "#align(center, image(%s, alt: %s, width: 9.2cm))"
    return raw(opening:format(quoted(image.src), quoted(pandoc.utils.stringify(image.caption))))
  end,
  program = program,
  ["chapter-begin"] = nothing,
  ["chapter-end"] = nothing,
  group = content,
  opening = content,
  highlights = call("highlights"),
  designer = call("designer"),
  ["do"] = content,
  ["do-not"] = content,
  answer = function(div)
    local title, rest = wrapped("#leading[", { div.content[1] }, "]"), { table.unpack(div.content, 2) }
    title:extend(rest)
    return wrapped("#answer[", title, "]")
  end,
  partial = call("partial-report"),
  ["answer-side"] = function(div)
    return wrapped("#answer-side(" .. quoted(div.attributes.side) .. ")[", div.content, "]")
  end,
  ["errata-sheet"] = call("errata-sheet"),
  outline = function(div)
    return raw("#contents(" .. div.attributes.depth .. ")")
  end,
  ["end-of-report"] = function()
    return raw('#[#metadata("end of report") <end-of-report>]')
  end,
  comparison = function(div)
    local result = pandoc.List({ raw("#comparison(") })
    for _, side in ipairs(div.content) do
      local heading = side.attributes.heading or headings[side.classes[#side.classes]]
      local opening = "(heading: " .. quoted(heading) .. ", wraps: " .. tostring(is_text(side)) .. ", body: ["
      result:extend(wrapped(opening, side.content, "]),"))
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
  evidence = call("evidence"),
  part = call("part"),
  leading = call("leading"),
  fold = function(div)
    return div.classes:includes("kept") and div.content or {}
  end,
  ["code-lines"] = call("code-lines"),
  explorable = nothing,
  lines = function(div)
    return pandoc.Para({ pandoc.Code(div.attributes.name), pandoc.Str(", "), pandoc.Code(div.attributes.place) })
  end,
  ["latex-sources"] = nothing,
  ["step-sources"] = nothing,
  passage = nothing,
  ["reader-copy"] = nothing,
}

function Div(div)
  local convert = converters[div.classes[1]]
  if convert then
    return convert(div)
  end
end

-- Some chapters and sections begin on a page of their own.
function Header(header)
  if header.classes:includes("breaking") then
    return { raw("#pagebreak(weak: true)"), header }
  end
end

function Span(span)
  if span.classes:includes("badge") then
    local result = pandoc.List({ pandoc.RawInline("typst", "#badge(" .. quoted(span.classes[2]) .. ")[") })
    result:extend(span.content)
    result:insert(pandoc.RawInline("typst", "]"))
    return result
  elseif span.classes:includes("remark") then
    local result = pandoc.List({ pandoc.RawInline("typst", "#remark[") })
    result:extend(span.content)
    result:insert(pandoc.RawInline("typst", "]"))
    return result
  elseif span.classes:includes("broken") then
    return {}
  end
end

-- The source files are in the HTML alone: here they are named.
function Link(link)
  if link.classes:includes("file") then
    return pandoc.Code(pandoc.utils.stringify(link.content))
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

-- Typst would break a line behind the stroke of a unit.
function Str(str)
  local unit = str.text:match("^[%a·µ²0-9]+/[%a²]+")
  if unit and #str.text <= 12 and not str.text:find("/", #unit + 1, true) then
    return pandoc.RawInline("typst", "#box[" .. str.text:gsub("([%[%]#@$*_\\`<>~])", "\\%1") .. "]")
  end
end
