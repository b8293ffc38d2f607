extends TestCase
## Displays of a station show the same moment, however the network delays what they tell.

const RATE: float = 60.0
## The clocks of the two processes differ by this, µs.
const APART_USEC: int = 5_000_000


## Two displays whose snapshots come through networks of their own: frames of two lengths, datagrams
## between them that take up to so long, s, and are lost now and then. Returns by how many ticks
## what they show differs at most, whether time went back, by how many ticks the leader waits, and
## how far apart the station stands in the world at the same tick, m: it drives through a curve.
func _play(p_jitter_s: float, p_behind_ticks: float) -> Array:
	var noise: RandomNumberGenerator = RandomNumberGenerator.new()
	noise.seed = 3
	var sides: Array[StationAgreement] = [StationAgreement.new(true), StationAgreement.new(false)]
	var frames: Array[int] = [16_000, 23_000]
	var offsets: Array[int] = [0, APART_USEC]
	var due: Array[int] = [0, 7_000]
	var shown: Array[float] = [0.0, 0.0]
	var shown_at: Array[int] = [0, 0]
	var waiting: Array[Array] = []
	var most: float = 0.0
	var went_back: bool = false
	var most_m: float = 0.0
	for now: int in range(0, 20_000_000, 1_000):
		for letter: Array in waiting.duplicate():
			if letter[0] <= now:
				waiting.erase(letter)
				sides[letter[1]].take(letter[2], now + offsets[letter[1]])
		for side: int in 2:
			if now < due[side]:
				continue
			due[side] += frames[side]
			var clock: int = now + offsets[side]
			var own: float = 1000.0 + now * 1e-6 * RATE - side * p_behind_ticks
			var tick: float = sides[side].agree(own, clock, RATE, clock)
			went_back = went_back or tick < shown[side]
			shown[side] = tick
			shown_at[side] = now
			if side == 1 and now > 2_000_000:
				var place: Vector3 = sides[1].track.at(tick).mount.origin
				most_m = maxf(most_m, place.distance_to(_drive(tick).origin))
			if noise.randf() > 0.05:
				var message: StationMessage = StationMessage.new()
				message.kind = side as StationMessage.Kind
				message.sender = side + 1
				message.sequence = now
				message.sent_usec = clock
				message.at_usec = clock
				message.tick = tick if side == 0 else own
				message.rate = RATE
				message.mount = _drive(tick)
				var late: int = 200 + int(noise.randf() * p_jitter_s * 1e6)
				waiting.append([now + late, 1 - side, message])
		if now > 2_000_000:
			# What each would show at this moment.
			var here: float = shown[0] + (now - shown_at[0]) * 1e-6 * RATE
			var there: float = shown[1] + (now - shown_at[1]) * 1e-6 * RATE
			most = maxf(most, absf(here - there))
	return [most, went_back, sides[0].wait, most_m]


## A station on a vehicle at 20 m/s in a curve of 60 m radius, 2 m beside its middle.
func _drive(p_tick: float) -> Transform3D:
	var angle: float = 20.0 / 60.0 * (p_tick - 1000.0) / RATE
	return Transform3D(Basis(Vector3.UP, angle), Vector3.ZERO).translated_local(Vector3(62, 1, 0))


func test_never_more_than_a_tick_apart_under_jitter() -> void:
	var found: Array = _play(0.020, 0.0)
	is_true(found[0] < 1.0, "apart by %.3f ticks" % found[0])
	is_false(found[1], "time went back")
	is_true(found[3] < 0.02, "the station is apart by %.4f m" % found[3])


func test_the_leader_waits_for_a_display_that_gets_its_snapshots_later() -> void:
	var found: Array = _play(0.020, 3.0)
	is_true(found[0] < 1.0, "apart by %.3f ticks" % found[0])
	is_false(found[1], "time went back")
	is_true(found[3] < 0.02, "the station is apart by %.4f m" % found[3])
	is_true(found[2] > 2.0 and found[2] < 5.0, "waits %.2f ticks" % found[2])


func test_alone_each_goes_on_by_itself() -> void:
	for leads: bool in [true, false]:
		var alone: StationAgreement = StationAgreement.new(leads)
		equal(alone.agree(100.0, 0, RATE, 0), 100.0)
		equal(alone.agree(101.0, 20_000, RATE, 20_000), 101.0)


func test_a_follower_does_not_hear_another_follower() -> void:
	var follower: StationAgreement = StationAgreement.new(false)
	var message: StationMessage = StationMessage.new()
	message.kind = StationMessage.Kind.WANT
	message.rate = RATE
	message.tick = 5.0
	follower.take(message, 0)
	is_null(follower.leader_message())
	equal(follower.agree(100.0, 0, RATE, 0), 100.0)


func test_nobody_waits_for_a_display_that_has_stopped() -> void:
	var leader: StationAgreement = StationAgreement.new(true)
	var message: StationMessage = StationMessage.new()
	message.kind = StationMessage.Kind.WANT
	message.rate = RATE
	message.tick = 100.0
	leader.take(message, 0)
	for frame: int in range(0, 1000, 16):
		leader.agree(100.0 + frame * 0.06, frame * 1000, RATE, frame * 1000)
	is_true(leader.wait < 0.5, "waits %.2f ticks" % leader.wait)
