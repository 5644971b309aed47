-- Lets a variant be tried again that ended its workers: at once where its sweep goes on, else when it is asked for.
-- base, entry of the dead stream.
-- "none", "again" or "ended".
local base, dead = unpack(ARGV)
local kept = redis.call('XRANGE', base .. ':dead', dead, dead)[1]
if not kept then return 'none' end
local told = {}
for i = 1, #kept[2], 2 do told[kept[2][i]] = kept[2][i + 1] end
redis.call('DEL', base .. ':poison:' .. told.digest .. ':' .. told.index)
redis.call('XDEL', base .. ':dead', dead)
local sweep = base .. ':sweep:' .. told.sweep
if redis.call('HGET', sweep .. ':lines', told.index) ~= 'dead' then return 'ended' end
redis.call('HDEL', sweep .. ':lines', told.index)
redis.call('SETBIT', sweep .. ':seen', told.index, 0)
redis.call('XADD', base .. ':' .. told.lane, '*', 'sweep', told.sweep, 'index', told.index)
redis.call('HINCRBY', sweep, 'open', 1)
return 'again'
