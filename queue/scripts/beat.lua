-- A worker is well, and works on these; lets go of what is known of workers that have long been silent.
-- base, worker, then lane, entry and sweep of each variant that it computes.
-- The entries that it is to stop: somebody else has them, or nobody wants them.
local base, worker = ARGV[1], ARGV[2]
local time = redis.call('TIME')
local now = time[1] * 1000 + math.floor(time[2] / 1000)
redis.pcall('ZADD', base .. ':workers', now, worker)
local stop = {}
for i = 3, #ARGV, 3 do
  local stream, entry, id = base .. ':' .. ARGV[i], ARGV[i + 1], ARGV[i + 2]
  local held = redis.pcall('XPENDING', stream, 'workers', entry, entry, 1)
  if held.err or not held[1] or held[1][2] ~= worker or redis.call('EXISTS', base .. ':sweep:' .. id) == 0 then
    stop[#stop + 1] = entry
  else
    redis.call('XCLAIM', stream, 'workers', worker, 0, entry, 'JUSTID')
  end
end
for _, silent in ipairs(redis.call('ZRANGEBYSCORE', base .. ':workers', '-inf', now - 600000, 'LIMIT', 0, 4)) do
  local idle = true
  for _, lane in ipairs({'interactive', 'batch'}) do
    local held = redis.pcall('XPENDING', base .. ':' .. lane, 'workers', '-', '+', 1, silent)
    if held.err or held[1] then
      idle = idle and held.err
    else
      redis.call('XGROUP', 'DELCONSUMER', base .. ':' .. lane, 'workers', silent)
    end
  end
  if idle then redis.call('ZREM', base .. ':workers', silent) end
end
return stop
