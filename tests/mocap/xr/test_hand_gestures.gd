extends TestCase
## Gestures of a tracked hand, of any size and anywhere, without chatter.

const STEP_S: float = 1.0 / 72.0
const STRETCHED: PackedFloat32Array = [0.05, 0.05, 0.05, 0.05]
const BENT: PackedFloat32Array = [1.1, 1.1, 1.1, 1.1]

var _gestures: HandGestures = HandGestures.new()
var _hand: XRHandTracker = XRHandTracker.new()
var _events: Array[String] = []
var _place: Transform3D = Transform3D(Basis(Vector3.RIGHT, 0.7), Vector3(0.3, 1.2, -0.4))
var _scale: float = 1.0


func before_each() -> void:
	_gestures.began.connect(_on_began)
	_gestures.ended.connect(_on_ended)


func test_each_gesture_at_any_place_and_size() -> void:
	for scale: float in [0.8, 1.0, 1.2]:
		_scale = scale
		for turn: float in [0.0, 1.0, -2.0]:
			_place = Transform3D(Basis(Vector3.UP, turn), Vector3(turn, 1.0, 0.0))
			_show(STRETCHED, Vector3(0.0, 0.0, 1.0))
			equal(_gestures.gesture, HandGestures.Gesture.OPEN)
			_show(BENT, Vector3(0.3, -0.5, 1.0))
			equal(_gestures.gesture, HandGestures.Gesture.FIST)
			is_true(_gestures.grip > 0.85)
			_show([0.05, 1.1, 1.1, 1.1], Vector3(0.3, -0.5, 1.0))
			equal(_gestures.gesture, HandGestures.Gesture.POINT)
			_pinch()
			equal(_gestures.gesture, HandGestures.Gesture.PINCH)
			is_true(_gestures.pinch > 0.9)
			_show(BENT, Vector3(0.0, 1.0, 0.0))
			equal(_gestures.gesture, HandGestures.Gesture.THUMB_UP)
	# The same thumb to the side is a fist.
	_place = Transform3D(Basis(Vector3.BACK, PI / 2.0), Vector3.ZERO)
	_show(BENT, Vector3(0.0, 1.0, 0.0))
	equal(_gestures.gesture, HandGestures.Gesture.FIST)


func test_a_hand_at_the_limit_does_not_chatter() -> void:
	_show(STRETCHED, Vector3(0.0, 0.0, 1.0))
	_show(BENT, Vector3(0.3, -0.5, 1.0))
	_events.clear()
	for step: int in 200:
		var bend: float = 0.78 + sin(step * 2.0) * 0.05
		_pose([bend, bend, bend, bend], Vector3(0.3, -0.5, 1.0))
		_gestures.advance(_hand, STEP_S)
	equal(_events, [] as Array[String])


func test_a_hand_that_is_lost_ends_its_gesture() -> void:
	_show(BENT, Vector3(0.3, -0.5, 1.0))
	_hand.has_tracking_data = false
	for _step: int in 10:
		_gestures.advance(_hand, STEP_S)
	equal(_events, ["+2", "-2"] as Array[String])
	for _step: int in 10:
		_gestures.advance(null, STEP_S)
	equal(_gestures.gesture, HandGestures.Gesture.OPEN)


func test_one_wrong_frame_is_no_gesture() -> void:
	_show(STRETCHED, Vector3(0.0, 0.0, 1.0))
	_events.clear()
	_pose(BENT, Vector3(0.3, -0.5, 1.0))
	_gestures.advance(_hand, STEP_S)
	_show(STRETCHED, Vector3(0.0, 0.0, 1.0))
	equal(_events, [] as Array[String])


func _show(p_bends: PackedFloat32Array, p_thumb: Vector3) -> void:
	_pose(p_bends, p_thumb)
	for _step: int in 12:
		_gestures.advance(_hand, STEP_S)


func _pinch() -> void:
	_pose([0.9, 0.3, 0.3, 0.3], Vector3(0.0, 0.0, 1.0))
	var tip: Transform3D = _hand.get_hand_joint_transform(XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP)
	tip.origin += _place.basis * Vector3(0.0, 0.01, 0.0) * _scale
	_hand.set_hand_joint_transform(XRHandTracker.HAND_JOINT_THUMB_TIP, tip)
	for _step: int in 12:
		_gestures.advance(_hand, STEP_S)


## Fingers along +Z that bend down, each joint by an angle; the thumb in a direction.
func _pose(p_bends: PackedFloat32Array, p_thumb: Vector3) -> void:
	_hand.has_tracking_data = true
	_put(1, Vector3.ZERO)
	for finger: int in 4:
		var side: float = 0.03 - 0.02 * finger
		var at: Vector3 = Vector3(side * 0.5, 0.0, 0.02)
		var first: int = 6 + 5 * finger
		var way: Vector3 = Vector3.BACK
		_put(first, at)
		for joint: int in range(1, 5):
			at += way * [0.0, 0.07, 0.04, 0.025, 0.02][joint]
			_put(first + joint, at)
			way = way.rotated(Vector3.RIGHT, p_bends[finger])
	var base: Vector3 = Vector3(0.03, 0.0, 0.03)
	for joint: int in 4:
		_put(2 + joint, base + p_thumb.normalized() * 0.032 * joint)


func _put(p_joint: int, p_place: Vector3) -> void:
	var at: Transform3D = Transform3D(_place.basis, _place * (p_place * _scale))
	_hand.set_hand_joint_transform(p_joint as XRHandTracker.HandJoint, at)
	_hand.set_hand_joint_flags(
		p_joint as XRHandTracker.HandJoint, 15 as XRHandTracker.HandJointFlags
	)


func _on_began(p_gesture: HandGestures.Gesture) -> void:
	_events.append("+%d" % p_gesture)


func _on_ended(p_gesture: HandGestures.Gesture) -> void:
	_events.append("-%d" % p_gesture)
