-- The search of help: which rows speak of some words, best first.
local entries = require "rotor.entries"
local names = require "rotor.names"
local words = require "rotor.words"

local search = {}

-- What a hit is worth: in the name itself, in the words of rotor.words, in signature and summary.
local kWeights = { 8, 5, 2 }
local kPhrase = 2  -- a phrase of several words counts so many times a word

local kTier = 1000  -- more than any sum of such worths

local kIgnored = {}
for word in ("a an and as at by do for from how i in is it my of on or the to what with"):gmatch "%a+" do
  kIgnored[word] = true
end

-- In a search euler_vector, "Euler-vector" and "Euler vectors" are the same.
local function searchable(s)
  return (s:lower():gsub("[%s_-]+%f[%w]", " "):gsub("%f[%a]axes%f[%A]", "axis"):gsub("matrices", "matrix"))
end

-- Lua's pattern for a word or phrase: in the singular, and nothing in it is magic.
local function pattern(piece)
  if #piece > 3 then piece = piece:gsub("([^sui])s$", "%1") end
  return (piece:gsub("%p", "%%%0"))
end

--- How well the text has the piece, from 0 to 1: as a whole, at the beginning of a word, or, in a name, inside.
local function quality(text, piece, is_name)
  local plain = pattern(piece)
  local begins = piece:find "^%w" and "%f[%w]" or ""
  if text:find(begins .. plain .. "s?%f[^%w]") then return 1 end
  if #piece < 3 then return 0 end
  return text:find(begins .. plain) and 0.7 or is_name and text:find(plain) and 0.4 or 0
end

-- The best worth of the piece in the first `count` of a row's fields.
local function worth(fields, piece, count)
  local best = 0
  for i = 1, count do best = math.max(best, kWeights[i] * quality(fields[i], piece, i == 1)) end
  return best
end

local function fields_of(row)
  local name = names.full_name(row)
  local signature = (row.signature or ""):gsub("%s*%->.*$", "")
  return { searchable(row.name), searchable(words[name] or ""),
    searchable(table.concat({ name:gsub("[.:]", " "), signature, row.summary or "" }, "\n")) }
end

-- All that is searched: the rows, and the lines of pages that are rows themselves.
local function documents()
  local rows = {}
  for _, row in ipairs(entries) do rows[#rows + 1] = row end
  for _, row in ipairs(entries) do
    for _, line in ipairs(row.lines and row.lines() or {}) do rows[#rows + 1] = line end
  end
  return rows
end

-- The rows that score, by the highest score; of equals the one that comes first.
local function ranked(rows, score)
  local found, scores, place = {}, {}, {}
  for i, row in ipairs(rows) do
    scores[row], place[row] = score(fields_of(row)), i
    if scores[row] > 0 then found[#found + 1] = row end
  end
  table.sort(found, function(a, b)
    if scores[a] ~= scores[b] then return scores[a] > scores[b] end
    return place[a] < place[b]
  end)
  return found
end

-- The words that tell something: letters and digits alone do not, and are looked for as a phrase if there is no word.
local function pieces_of(query)
  local pieces = {}
  for word in query:gmatch "%S+" do
    if #word > 1 and not kIgnored[word] then pieces[#pieces + 1] = word end
  end
  return pieces[1] and pieces or { query }
end

--- The rows that have the words, best first: first those that have them as a phrase, then those that have all of them.
--- If there is none, the rows that have most of them, and true.
function search.rows(query)
  query = searchable(query):match "^%s*(.-)%s*$"
  local pieces, rows = pieces_of(query), documents()
  local function score(fields)
    local sum, count = 0, 0
    for _, piece in ipairs(pieces) do
      local points = worth(fields, piece, 3)
      sum, count = sum + points, count + (points > 0 and 1 or 0)
    end
    local phrase = worth(fields, query, 3)
    return (phrase > 0 and (#pieces + 1)*kTier or count*kTier) + sum + kPhrase*phrase
  end
  local function complete(fields)
    local points = score(fields)
    return points >= #pieces*kTier and points or 0
  end
  local found = ranked(rows, complete)
  if found[1] or #pieces < 2 then return found, false end
  return ranked(rows, function(fields)
    local points = score(fields)
    return points >= kTier and points or 0
  end), true
end

--- The rows that have the word in their names or among their search words, best first.
function search.related(word)
  word = searchable(word)
  return ranked(entries, function(fields) return worth(fields, word, 2) end)
end

return search
