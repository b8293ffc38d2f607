extends SceneTree
## Runs the example of the package, and watches what it puts on the [XRBodyTracker].

## A joint that has turned so far moves, degrees.
const _TURNED_DEG: float = 25.0
const _VALID: int = (
	XRBodyTracker.JOINT_FLAG_ORIENTATION_VALID | XRBodyTracker.JOINT_FLAG_POSITION_VALID
)
const _MOVING: Array[XRBodyTracker.Joint] = [
	XRBodyTracker.JOINT_LEFT_UPPER_LEG,
	XRBodyTracker.JOINT_RIGHT_UPPER_LEG,
	XRBodyTracker.JOINT_LEFT_LOWER_LEG,
	XRBodyTracker.JOINT_LEFT_UPPER_ARM,
]

var _example: Node3D = null
var _first: Dictionary[int, Quaternion] = {}
var _turned: Dictionary[int, bool] = {}


func _initialize() -> void:
	_example = (load("res://addons/xbus/example/xbus.tscn") as PackedScene).instantiate()
	_example.connect(&"calibrated", func() -> void: print("calibrated"))
	root.add_child(_example)


func _process(_p_delta: float) -> bool:
	var tracker: XRBodyTracker = XRServer.get_tracker(_example.get(&"tracker_name"))
	if tracker == null or not tracker.has_tracking_data:
		return false
	for joint: XRBodyTracker.Joint in _MOVING:
		if (tracker.get_joint_flags(joint) & _VALID) != _VALID:
			continue
		var place: Transform3D = tracker.get_joint_transform(joint)
		var turn: Quaternion = place.basis.get_rotation_quaternion()
		if not place.is_finite():
			printerr("joint %d is nowhere" % joint)
			return true
		_first.get_or_add(joint, turn)
		if rad_to_deg(_first[joint].angle_to(turn)) > _TURNED_DEG:
			_turned[joint] = true
	if _turned.size() < _MOVING.size():
		return false
	print("all joints have moved")
	return true
