extends RefCounted
## One combination that the tracking benchmark measures, and the goals that belong to it.

## Names of the modes, in the order of [enum RagdollMotor.Actuation].
const MODES: PackedStringArray = [
	"direct_set", "spring_torque", "angular_motor", "velocity_motor", "position_motor", "limp"
]

const Case: GDScript = preload("tracking_case.gd")

## How the limbs are driven.
var mode: RagdollMotor.Actuation = RagdollMotor.VELOCITY_MOTOR
## Who moves the hips: held or soft.
var root: RagdollMotor.RootMode = RagdollMotor.ROOT_HELD
## Ticks per second.
var hz: int = 60
## Ticks of delay that make the next sample known.
var buffer: int = 0
## Whether the person's own limbs collide.
var self_collision: bool = false
## Greatest values of what [method RagdollMotor.get_tracking] finds, by its keys: deg, ms, mm.
var goals: Dictionary[String, float] = {}


func _init(p_mode: String, p_root: String, p_hz: int, p_buffer: int) -> void:
	mode = MODES.find(p_mode) as RagdollMotor.Actuation
	root = RagdollMotor.ROOT_HELD if p_root == "held" else RagdollMotor.ROOT_SOFT
	hz = p_hz
	buffer = p_buffer
	if p_mode == "velocity_motor":
		_set_goals()


## What it is, for people.
func name() -> String:
	var who: String = "held" if root == RagdollMotor.ROOT_HELD else "soft"
	var text: String = "%s, %s, %d Hz" % [MODES[mode], who, hz]
	if buffer > 0:
		text += ", buffer %d" % buffer
	return text + (", self-collision" if self_collision else "")


## The combinations for which there are goals, and every other mode once.
static func usual() -> Array:
	var cases: Array = []
	for root_name: String in ["held", "soft"]:
		cases.append(Case.new("velocity_motor", root_name, 60, 0))
		cases.append(Case.new("velocity_motor", root_name, 60, 1))
		cases.append(Case.new("velocity_motor", root_name, 30, 0))
		cases.append(Case.new("velocity_motor", root_name, 120, 0))
	var touching: Case = Case.new("velocity_motor", "soft", 60, 0)
	touching.self_collision = true
	touching.goals = {}
	cases.append(touching)
	for mode_name: String in MODES:
		if mode_name != "velocity_motor" and mode_name != "limp":
			cases.append(Case.new(mode_name, "held", 60, 0))
	return cases


## Every mode with both roots at 30, 60 and 120 Hz.
static func all() -> Array:
	var cases: Array = []
	for mode_name: String in MODES:
		for root_name: String in ["held", "soft"]:
			for rate: int in [30, 60, 120]:
				cases.append(Case.new(mode_name, root_name, rate, 0))
	return cases


func _set_goals() -> void:
	if buffer > 0:
		if hz == 60 and buffer == 1:
			goals = {"mean_deg": 0.2, "p95_deg": 0.6}
	elif hz == 60:
		goals = {"mean_deg": 1.2, "p95_deg": 3.7, "lag_s": 4.0}
		if root == RagdollMotor.ROOT_HELD:
			goals["distance_m"] = 6.0
	elif hz == 30:
		goals = {"mean_deg": 3.0}
	elif hz == 120:
		goals = {"mean_deg": 1.0}
