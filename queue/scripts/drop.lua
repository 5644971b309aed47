-- Lets go of a sweep. Its variants in the stream are passed over when they are taken, and stopped at the next heartbeat.
-- base, id.
local base, id = unpack(ARGV)
local sweep = base .. ':sweep:' .. id
redis.call('ZREM', base .. ':sweeps', id)
for _, index in ipairs(redis.call('HKEYS', sweep .. ':lines')) do redis.call('UNLINK', sweep .. ':line:' .. index) end
return redis.call('DEL', sweep, sweep .. ':lines', sweep .. ':seen')
