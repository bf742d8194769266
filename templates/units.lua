-- Puts a no-break space between a number and its unit, and between a word such as "figure" and its number. It runs when
-- the text is read, so that all forms of the report have it.

local NO_BREAK = "\u{a0}"

local function set(words)
  local result = {}
  for word in words:gmatch("%S+") do
    result[word] = true
  end
  return result
end

local units = set(
  "m mm µm μm nm km s ms µs μs ns min Hz kHz MHz N mN kN kg g rad dB J mJ µJ W mW V K Pa GPa % ‰ ° degrees decades "
    .. "m² mm² m/s² N² px MB kB"
)
local continued = set("s s² s/m m N decade gap gaps")
local named = set(
  "figure figures Figure Figures equation equations Equation Equations section sections Section Sections table tables "
    .. "Table Tables listing listings Listing Listings chapter chapters Chapter Chapters appendix Appendix step Step "
    .. "line lines page pages Eq. Eqs. Fig. Figs. Sec. Secs. App. Ch."
)

-- What stands between opening and closing punctuation.
local function bare(text)
  return (text:gsub("“", ""):gsub("”", ""):gsub("^[%(%[]+", ""):gsub("[%.,;:%)%]?!]+$", ""))
end

-- A product or quotient of units, such as kN/m or N·s/m.
local function is_unit(text)
  local word = bare(text)
  if word == "" then
    return false
  end
  for part in word:gsub("·", "/"):gmatch("[^/]+") do
    if not (units[part] or continued[part] or part == "1") then
      return false
    end
  end
  return units[word:gsub("·", "/"):match("^[^/]+")] or word:sub(1, 2) == "1/"
end

local digits = set("⁰ ¹ ² ³ ⁴ ⁵ ⁶ ⁷ ⁸ ⁹ π")

local function ends_with_number(inline)
  if inline.t == "Str" then
    return inline.text:find("%d$") ~= nil or digits[inline.text:match(utf8.charpattern .. "$")] ~= nil
  elseif inline.t == "Math" then
    return inline.text:find("[%d}]%s*$") ~= nil or inline.text:find("\\pi%s*$") ~= nil
  end
  return false
end

local function begins_with_number(inline)
  if inline.t == "Str" then
    return inline.text:find("^[%(]?%d") ~= nil or inline.text:find("^[A-E]%.?%d") ~= nil or inline.text:find("^[A-E]$") ~= nil
  end
  return inline.t == "Link" and inline.content[1] ~= nil and begins_with_number(inline.content[1])
end

local function is_gap(inline)
  return inline ~= nil and (inline.t == "Space" or inline.t == "SoftBreak")
end

local function belong_together(before, after, was_unit)
  if after.t == "Str" and is_unit(after.text) and ends_with_number(before) then
    return true
  elseif after.t == "Str" and was_unit and before.text == bare(before.text) and continued[bare(after.text)] then
    return bare(after.text) == "s" or bare(after.text) == "s/m"
  end
  return before.t == "Str" and named[before.text:gsub("^%(", "")] and begins_with_number(after)
end

function Inlines(inlines)
  local was_unit = false
  for position = 2, #inlines - 1 do
    local before, gap, after = inlines[position - 1], inlines[position], inlines[position + 1]
    if is_gap(gap) then
      local bound = belong_together(before, after, was_unit)
      if bound then
        inlines[position] = pandoc.Str(NO_BREAK)
      end
      was_unit = bound and after.t == "Str" and is_unit(after.text)
    end
  end
  return inlines
end
