-- A worker ends that computes nothing any more.
-- base, worker.
local base, worker = unpack(ARGV)
redis.call('ZREM', base .. ':workers', worker)
for _, lane in ipairs({'interactive', 'batch'}) do
  local held = redis.pcall('XPENDING', base .. ':' .. lane, 'workers', '-', '+', 1, worker)
  if not held.err and not held[1] then redis.call('XGROUP', 'DELCONSUMER', base .. ':' .. lane, 'workers', worker) end
end
return 1
