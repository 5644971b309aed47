-- Gives a lease back, unless somebody else has it by now.
-- key, owner.
if redis.call('GET', ARGV[1]) == ARGV[2] then return redis.call('DEL', ARGV[1]) end
return 0
