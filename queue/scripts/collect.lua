-- What the owner of a sweep does again and again: lets go of the lines that it has, adds variants, asks for more lines.
-- base, id, milliseconds to live, variant before which to stop adding, most bytes, then the variants that it has.
-- "gone" when the sweep is not there, else "here", or "idle" when nothing is computed, and pairs of a variant and its
-- line, or "long" for one that the owner then reads itself, or "dead".
local base, id, ttl, limit, most = unpack(ARGV, 1, 5)
local sweep = base .. ':sweep:' .. id
local lines, seen = sweep .. ':lines', sweep .. ':seen'
local known = redis.call('HMGET', sweep, 'lane', 'total', 'next', 'open', 'digest')
if not known[1] then return {'gone'} end
local stream, total, next, open = base .. ':' .. known[1], tonumber(known[2]), tonumber(known[3]), tonumber(known[4])
for i = 6, #ARGV do
  redis.call('HDEL', lines, ARGV[i])
  redis.call('UNLINK', sweep .. ':line:' .. ARGV[i])
end

local time = redis.call('TIME')
local now = time[1] * 1000 + math.floor(time[2] / 1000)
local threads = 1
for _, worker in ipairs(redis.call('ZRANGEBYSCORE', base .. ':workers', now - 15000, '+inf')) do
  threads = threads + (tonumber(string.match(worker, '/(%d+)$')) or 1)
end
-- What was counted wrong, because a part of this was lost, rights itself.
if open > 0 and redis.call('XLEN', stream) == 0 then open = 0 end
local any_dead = redis.call('EXISTS', base .. ':dead') == 1
-- Where Redis has no memory to take more, what is there is still told.
local function add()
  while next < total and next < tonumber(limit) and open < 4 * threads do
    if redis.call('GETBIT', seen, next) == 0 then
      if any_dead and redis.call('EXISTS', base .. ':poison:' .. known[5] .. ':' .. next) == 1 then
        redis.call('SETBIT', seen, next, 1)
        redis.call('HSET', lines, next, 'dead')
      else
        redis.call('XADD', stream, '*', 'sweep', id, 'index', next)
        open = open + 1
      end
    end
    next = next + 1
  end
  redis.call('HSET', sweep, 'next', next, 'open', open)
end
pcall(add)
-- Every line has at least as long as its sweep, so now and then is enough.
if redis.call('PTTL', sweep) < 0.75 * ttl then
  for _, key in ipairs({sweep, lines, seen}) do redis.call('PEXPIRE', key, ttl) end
  for _, field in ipairs(redis.call('HKEYS', lines)) do redis.call('PEXPIRE', sweep .. ':line:' .. field, ttl) end
  pcall(redis.call, 'ZADD', base .. ':sweeps', now + tonumber(ttl), id)
end

local told, bytes = {open > 0 and 'here' or 'idle'}, 0
local pairs_of = redis.call('HRANDFIELD', lines, 64, 'WITHVALUES')
for i = 1, #pairs_of, 2 do
  local size = #pairs_of[i + 1]
  if pairs_of[i + 1] == 'long' then size = redis.call('STRLEN', sweep .. ':line:' .. pairs_of[i]) end
  if bytes > 0 and bytes + size > tonumber(most) then break end
  bytes = bytes + size
  told[#told + 1] = pairs_of[i]
  told[#told + 1] = pairs_of[i + 1]
end
return told
