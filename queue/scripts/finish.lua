-- Keeps what came of a variant, unless somebody else was quicker, and ends the entry.
-- base, lane, entry, sweep, variant, line.
-- "counted", "twice", or "unwanted" when the sweep is not there any more.
local base, lane, entry, id, index, line = unpack(ARGV)
local stream, sweep = base .. ':' .. lane, base .. ':sweep:' .. id
local outcome = 'unwanted'
if redis.call('EXISTS', sweep) == 1 then
  outcome = 'twice'
  -- First what Redis may have no memory for, so that either all is done or nothing.
  if redis.call('SETBIT', sweep .. ':seen', index, 1) == 0 then
    outcome = 'counted'
    redis.call('HSET', sweep .. ':lines', index, line)
    redis.call('PEXPIRE', sweep .. ':lines', math.max(1, redis.call('PTTL', sweep)))
  end
end
if redis.call('XACK', stream, 'workers', entry) == 1 and outcome ~= 'unwanted' then
  redis.call('HINCRBY', sweep, 'open', -1)
end
redis.call('XDEL', stream, entry)
redis.pcall('HINCRBY', base .. ':counts', outcome, 1)
return outcome
