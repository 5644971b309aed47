-- Gives a worker one variant: first of those who wait for an answer, first one whose worker is silent.
-- base, worker, milliseconds after which a worker is silent, most deliveries.
-- {lane, entry, sweep, variant, deliveries}, or {"none", last entry of the one stream, of the other}.
local base, worker, idle, most = unpack(ARGV)

local function let_go(stream, entry)
  redis.call('XACK', stream, 'workers', entry)
  redis.call('XDEL', stream, entry)
end

-- Who has ended so many workers is given to no other.
local function bury(lane, entry, fields, deliveries, last)
  local stream = base .. ':' .. lane
  let_go(stream, entry)
  local id, index = fields[2], fields[4]
  local sweep = base .. ':sweep:' .. id
  local digest = redis.call('HGET', sweep, 'digest')
  if not digest then return end
  redis.call('XADD', base .. ':dead', 'MAXLEN', '~', 1000, '*', 'sweep', id, 'index', index, 'lane', lane, 'deliveries',
    deliveries, 'worker', last, 'digest', digest)
  redis.call('SET', base .. ':poison:' .. digest .. ':' .. index, 1, 'EX', 3600)
  redis.call('HINCRBY', sweep, 'open', -1)
  if redis.call('SETBIT', sweep .. ':seen', index, 1) == 0 then redis.call('HSET', sweep .. ':lines', index, 'dead') end
end

local function silent(lane)
  local stream = base .. ':' .. lane
  local found = redis.call('XPENDING', stream, 'workers', 'IDLE', idle, '-', '+', 1)[1]
  if not found then return nil end
  local entry, last, deliveries = found[1], found[2], found[4]
  local kept = redis.call('XRANGE', stream, entry, entry)[1]
  if not kept then
    redis.call('XACK', stream, 'workers', entry)
    return {}
  end
  if deliveries >= tonumber(most) then
    bury(lane, entry, kept[2], deliveries, last)
    return {}
  end
  redis.call('XCLAIM', stream, 'workers', worker, 0, entry)
  redis.pcall('HINCRBY', base .. ':counts', 'again', 1)
  return {entry, kept[2], deliveries + 1}
end

local function fresh(lane)
  local read = redis.call('XREADGROUP', 'GROUP', 'workers', worker, 'COUNT', 1, 'STREAMS', base .. ':' .. lane, '>')
  if not read or not read[1] then return nil end
  local entry = read[1][2][1]
  return {entry[1], entry[2], 1}
end

local last = {}
for _, lane in ipairs({'interactive', 'batch'}) do
  local stream = base .. ':' .. lane
  local group = redis.pcall('XPENDING', stream, 'workers')
  if group.err then redis.call('XGROUP', 'CREATE', stream, 'workers', '0', 'MKSTREAM') end
  for _ = 1, 1000 do
    local got = silent(lane) or fresh(lane)
    if not got then break end
    if got[1] then
      local id, index = got[2][2], got[2][4]
      if redis.call('EXISTS', base .. ':sweep:' .. id) == 1 then return {lane, got[1], id, index, got[3]} end
      let_go(stream, got[1])
    end
  end
  local info = redis.call('XINFO', 'STREAM', stream)
  for i = 1, #info, 2 do
    if info[i] == 'last-generated-id' then last[#last + 1] = info[i + 1] end
  end
end
return {'none', last[1], last[2]}
