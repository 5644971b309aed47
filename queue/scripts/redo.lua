-- Has a variant computed again whose line was damaged.
-- base, id, variant.
local base, id, index = unpack(ARGV)
local sweep = base .. ':sweep:' .. id
local lane = redis.call('HGET', sweep, 'lane')
if not lane then return 0 end
redis.call('SETBIT', sweep .. ':seen', index, 0)
redis.call('HDEL', sweep .. ':lines', index)
redis.call('UNLINK', sweep .. ':line:' .. index)
redis.call('XADD', base .. ':' .. lane, '*', 'sweep', id, 'index', index)
redis.call('HINCRBY', sweep, 'open', 1)
return 1
