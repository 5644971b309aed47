-- Takes a sweep in, or takes in again one that was lost. Its variants are added by `collect`.
-- base, id, lane, body, digest of the body, about, variants, first variant, most sweeps, milliseconds to live,
-- then the variants that its owner has already.
-- "taken", "full" when there are as many sweeps as may be, "unmanned" when no worker is there.
local base, id, lane, body, digest, about, total, first, most, ttl = unpack(ARGV, 1, 10)
local time = redis.call('TIME')
local now = time[1] * 1000 + math.floor(time[2] / 1000)
redis.call('ZREMRANGEBYSCORE', base .. ':sweeps', '-inf', now)
if redis.call('ZCOUNT', base .. ':workers', now - 15000, '+inf') == 0 then return 'unmanned' end
local known = redis.call('ZSCORE', base .. ':sweeps', id)
if not known and redis.call('ZCARD', base .. ':sweeps') >= tonumber(most) then return 'full' end
local sweep = base .. ':sweep:' .. id
for _, index in ipairs(redis.call('HKEYS', sweep .. ':lines')) do redis.call('UNLINK', sweep .. ':line:' .. index) end
redis.call('DEL', sweep, sweep .. ':lines', sweep .. ':seen')
redis.call('HSET', sweep, 'lane', lane, 'body', body, 'digest', digest, 'about', about, 'total', total, 'next', first,
  'open', 0)
for i = 11, #ARGV do redis.call('SETBIT', sweep .. ':seen', ARGV[i], 1) end
redis.call('PEXPIRE', sweep, ttl)
redis.call('PEXPIRE', sweep .. ':seen', ttl)
redis.call('ZADD', base .. ':sweeps', now + tonumber(ttl), id)
return 'taken'
