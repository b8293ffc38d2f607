extends TestCase
## The menu before the wearer's eyes, pressed by a ray from a hand.

var _menu: HmdMenu = null
var _button: Button = null
var _panel: Control = null


func before_each() -> void:
	_menu = HmdMenu.new()
	add_child(_menu)
	_panel = Control.new()
	_button = Button.new()
	_button.position = Vector2(500.0, 400.0)
	_button.size = Vector2(200.0, 100.0)
	_panel.add_child(_button)


func after_each() -> void:
	_menu.close()
	_panel.free()
	_menu.free()


func test_it_opens_before_the_eyes_and_upright() -> void:
	var head: Transform3D = Transform3D(
		Basis(Vector3.UP, 1.0) * Basis(Vector3.RIGHT, 0.5), Vector3(2.0, 1.6, 1.0)
	)
	_menu.open(_panel, head)
	is_true(_menu.is_open())
	equal(_panel.size, Vector2(HmdMenu.SIZE_PX))
	var ahead: Vector3 = Basis(Vector3.UP, 1.0) * Vector3.FORWARD
	almost_equal((_menu.position - head.origin).normalized().dot(ahead), 1.0, 0.02)
	almost_equal(_menu.basis.y.distance_to(Vector3.UP), 0.0, 1e-5)


func test_a_ray_hits_where_it_points() -> void:
	_menu.open(_panel, Transform3D.IDENTITY)
	var middle: Transform3D = Transform3D(Basis.IDENTITY, _menu.position + Vector3(0.0, 0.0, 0.5))
	almost_equal(_menu.hit_by(middle).distance_to(Vector2(0.5, 0.5)), 0.0, 1e-4)
	var corner: Transform3D = middle.translated(Vector3(-0.49, 0.36, 0.0))
	is_true(_menu.hit_by(corner).x < 0.02 and _menu.hit_by(corner).y < 0.03)
	is_false(_menu.hit_by(middle.translated(Vector3(0.6, 0.0, 0.0))).is_finite())
	is_false(_menu.hit_by(middle.rotated_local(Vector3.UP, PI)).is_finite(), "away from it")
	var behind: Transform3D = Transform3D(Basis.IDENTITY, _menu.position - Vector3(0, 0, 0.5))
	is_false(_menu.hit_by(behind.rotated_local(Vector3.UP, PI)).is_finite(), "from behind")


func test_a_trigger_presses_what_is_pointed_at() -> void:
	var presses: Array[int] = [0]
	_button.pressed.connect(func() -> void: presses[0] += 1)
	_menu.open(_panel, Transform3D.IDENTITY)
	var on: Transform3D = Transform3D(Basis.IDENTITY, _menu.position + Vector3(0.0, 0.0, 0.5))
	var aside: Transform3D = on.translated(Vector3(0.4, 0.0, 0.0))
	for hand: int in 2:
		var hands: Array[Transform3D] = [aside, aside]
		hands[hand] = on
		for trigger: float in [0.0, 0.5, 0.9, 0.9, 0.5, 0.1]:
			var triggers: PackedFloat32Array = [0.0, 0.0]
			triggers[hand] = trigger
			_menu.point(hands, triggers)
	equal(presses[0], 2, "once by each hand")


func test_a_press_that_leaves_the_board_is_none() -> void:
	var presses: Array[int] = [0]
	_button.pressed.connect(func() -> void: presses[0] += 1)
	_menu.open(_panel, Transform3D.IDENTITY)
	var on: Transform3D = Transform3D(Basis.IDENTITY, _menu.position + Vector3(0.0, 0.0, 0.5))
	var away: Transform3D = on.translated(Vector3(2.0, 0.0, 0.0))
	_menu.point([on], [0.0])
	_menu.point([on], [1.0])
	_menu.point([away], [1.0])
	_menu.point([on], [0.0])
	equal(presses[0], 0)


func test_closing_gives_the_control_back() -> void:
	_menu.open(_panel, Transform3D.IDENTITY)
	_menu.close()
	is_false(_menu.is_open())
	is_null(_panel.get_parent())
	is_true(is_instance_valid(_panel))
