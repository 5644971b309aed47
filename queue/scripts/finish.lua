-- Keeps what came of a variant, unless somebody else was quicker, and ends the entry.
-- base, lane, entry, sweep, variant, line; instead of a long line, which lies there already, "long".
-- "counted", "twice", "unwanted" when the sweep is not there any more, or "absent", with nothing done, when Redis had no
-- memory for the long line.
local base, lane, entry, id, index, line = unpack(ARGV)
local stream, sweep = base .. ':' .. lane, base .. ':sweep:' .. id
local lines, place = sweep .. ':lines', sweep .. ':line:' .. index
if line == 'long' and redis.call('EXISTS', place) == 0 and redis.call('GETBIT', sweep .. ':seen', index) == 0 and
  redis.call('EXISTS', sweep) == 1 then
  return 'absent'
end
local outcome = 'unwanted'
if redis.call('EXISTS', sweep) == 1 then
  outcome = 'twice'
  -- First what Redis may have no memory for, so that either all is done or nothing.
  if redis.call('SETBIT', sweep .. ':seen', index, 1) == 0 then
    outcome = 'counted'
    redis.call('HSET', lines, index, line)
    for _, key in ipairs({lines, place}) do redis.call('PEXPIRE', key, math.max(1, redis.call('PTTL', sweep))) end
  end
end
-- The line of who was quicker is as good and has the same place.
if outcome ~= 'counted' and redis.call('HEXISTS', lines, index) == 0 then redis.call('UNLINK', place) end
if redis.call('XACK', stream, 'workers', entry) == 1 and outcome ~= 'unwanted' then
  redis.call('HINCRBY', sweep, 'open', -1)
end
redis.call('XDEL', stream, entry)
redis.pcall('HINCRBY', base .. ':counts', outcome, 1)
return outcome
