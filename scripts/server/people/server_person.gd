class_name ServerPerson
extends DrivenBody
## One of the people on the server: the body, and the motion that drives it.

# Numbers of old samples in a row after which a line is logged, and after which the wearer's clock
# counts as set back.
const _LATE: int = 5
const _NEW_CLOCK: int = 30
# Longest stage that a latency mark can hold, µs.
const _MAX_STEP_USEC: int = 655000

## Number of its entity.
var id: int = 0
## Number of the session that sends its motion.
var session: int = 0
## What the client sent about the wearer.
var card: PersonCard = PersonCard.new()
## Shown to the others.
var name: String = ""
## The scene's entity, or null.
var entity: Entity = null
## The body's joints.
var joints: PersonSkeleton = null
## Decides which moment of the motion a tick shows.
var clock: SampleClock = SampleClock.new()
## Moment of the motion that the last step ended at, s in the wearer's clock.
var moment_s: float = 0.0
## The body that carries the person, or null, and the person's own frame in that of the body.
var carrier: PhysicsBody3D = null
## Its entity, which outlives the body; -1 none.
var carrier_id: int = -1
## See [member carrier].
var seat: Transform3D = Transform3D.IDENTITY
## Whether the person only stands or lies on the carrier: friction carries, and only the wire uses
## the carrier's frame.
var rides: bool = false
## The seat that the person takes, sits in or leaves, or null.
var sitting: PersonSeat = null
## Samples that were too old.
var refused: int = 0
## The same since the last that was not.
var refused_in_a_row: int = 0
## From sampling to the end of the tick that used the sample, ms.
var delay: Statistics = Statistics.recent()


## Takes a sample that arrived at a time, s. One that was made here may be of a moment that is still
## ahead by some time, s.
func push_sample(p_sample: PoseSample, p_now_s: float, p_ahead_s: float = 0.0) -> void:
	var sample_s: float = p_sample.time_usec / 1e6
	var root: Vector3 = p_sample.root * scale + origin
	var driving: PoseSample = p_sample
	if sitting != null:
		root = sitting.place_of(root)
		driving = sitting.fit(p_sample)
	if ragdoll.push_sample(sample_s, driving, root):
		newest = p_sample
		refused_in_a_row = 0
		clock.arrived(sample_s - p_ahead_s, p_now_s)
		return
	refused += 1
	refused_in_a_row += 1
	if refused_in_a_row == _LATE:
		# Some are late because datagrams overtake each other in the network.
		var parts: Array = [name, _LATE]
		Log.limited("server", "sample %d" % session, "'%s' sent %d old samples in a row" % parts)
	if refused_in_a_row >= _NEW_CLOCK:
		# More than some late datagrams: the wearer's clock was set back.
		ragdoll.motor.clear_motion()


## Moves the own frame to where the carrier will be at the end of a step of this length, s.
func follow_carrier(p_delta_s: float) -> void:
	if rides:
		return
	if sitting != null:
		seat = sitting.advance(p_delta_s)
		sitting.pull(p_delta_s)
	var state: PhysicsDirectBodyState3D = PhysicsServer3D.body_get_direct_state(carrier.get_rid())
	var next: Transform3D = carrier.global_transform
	if state != null:
		# The engine's velocity is that of the centre of mass.
		var moves: Vector3 = state.linear_velocity
		moves -= state.angular_velocity.cross(state.center_of_mass)
		next = _moved(state.transform, moves, state.angular_velocity, p_delta_s)
	ragdoll.motor.set_frame(next * seat)


## Ends the carrying, and leaves the person where that has brought it.
func let_go() -> void:
	if sitting != null:
		sitting.release()
	sitting = null
	carrier = null
	carrier_id = -1
	rides = false


## Gives an encoder the sample that moved the person in a tick that ended at a time, µs.
func mark(p_encoder: SnapshotEncoder, p_now_usec: int) -> void:
	if newest == null or newest.sent_usec == 0:
		return
	var steps: PackedInt32Array = [
		mini(newest.held_usec, _MAX_STEP_USEC),
		clampi(newest.arrival_usec - newest.sent_usec, 0, _MAX_STEP_USEC),
		clampi(p_now_usec - newest.arrival_usec, 0, _MAX_STEP_USEC),
	]
	delay.add((steps[0] + steps[1] + steps[2]) / 1000.0)
	p_encoder.set_mark(id, newest.id, p_now_usec, steps)


## How well the body follows, how late, and its distance from its motion, m, for a report; of
## grounded people also the horizontal residual force, N, and the residual torque of the last step
## and its 95th percentile, N m.
func stats() -> Dictionary:
	var made: Dictionary = ragdoll.motor.get_tracking()
	made["name"] = name
	made["refused_samples"] = refused
	made["sample_to_tick_ms_p50"] = delay.percentile(0.5)
	made["sample_to_tick_ms_p95"] = delay.percentile(0.95)
	var tether: Vector3 = ragdoll.motor.get_tether()
	made["tether_m"] = Vector2(tether.x, tether.z).length()
	var balance: Dictionary = ragdoll.motor.get_balance()
	if not balance.is_empty():
		made["residual_n"] = balance["force_n"]
		made["residual_limit_n"] = balance["force_limit_n"]
		made["residual_nm"] = balance["torque_nm"]
		made["residual_p95_nm"] = balance["torque_p95_nm"]
	return made


static func _moved(
	p_transform: Transform3D, p_velocity: Vector3, p_spin: Vector3, p_delta_s: float
) -> Transform3D:
	var moved: Transform3D = p_transform
	moved.origin += p_velocity * p_delta_s
	if not p_spin.is_zero_approx():
		moved.basis = Basis(p_spin.normalized(), p_spin.length() * p_delta_s) * moved.basis
	return moved
