class_name ClientSeat
extends ClientPart
## What this client's user does and sees in the seat of a vehicle: controls, views, instruments, and
## what hands and motion platform feel.

## Duration of a gun's recoil, s.
const KICK_S: float = 0.06

var _controls: SeatControls = null
var _cues: ClientCues = null
## Where wheel and pedals are calibrated; null without a window.
var _panel: AxisPanel = null
var _prediction: DriverPrediction = null


func _ready() -> void:
	_controls = SeatControls.new()
	_cues = ClientCues.new()
	_prediction = DriverPrediction.new()
	add_child(_cues)
	add_child(_controls)
	add_child(_prediction)


func _physics_process(_delta: float) -> void:
	_cues.get_forces().wheel_position = -_controls.input.steer


func open(p_context: ClientContext) -> String:
	super(p_context)
	var drive: String = context.options.text("drive")
	if drive != "":
		_controls.list = DriveScript.parse(drive)
		if _controls.list.error != "":
			return _controls.list.error
	_controls.has_body = context.can(Roles.Capability.SEND_MOTION)
	_controls.view_changed.connect(context.scene.view.look_through)
	_controls.notified.connect(context.hud.show_news)
	_controls.seat_changed.connect(_on_seat_changed)
	if DisplayServer.get_name() != "headless":
		var hud: VehicleHud = (
			preload("res://scenes/vehicle/controls/vehicle_hud.tscn").instantiate()
		)
		add_child(hud)
		hud.follow(_controls)
		_panel = preload("res://scenes/vehicle/controls/axis_panel.tscn").instantiate()
		add_child(_panel)
		context.menu.add_entry(
			"Wheel and pedals", func() -> void: _panel.show_panel(_controls.reader.settings)
		)
	if context.options.is_on("prediction"):
		_prediction.follow(
			_controls,
			context.scene.replica,
			context.now_s,
			func() -> int: return context.link.clock.round_trip_usec
		)
	return _cues.open(context.options)


func begin_frame() -> void:
	if context.headset != null:
		_cues.tell_platform(context.headset.platform)


func advance(_delta_s: float) -> void:
	_controls.hands_off = context.is_menu_open() or (_panel != null and _panel.visible)
	_prediction.apply()


func report() -> Dictionary:
	return {"driving": _prediction.report()}


## Hands feel the guns of the vehicle: no position shows such a jolt.
func _on_seat_changed(p_seat: Seat) -> void:
	context.is_seated = p_seat != null
	if p_seat == null:
		return
	for node: Node in _controls.vehicle.find_children("*", "Node3D", true, false):
		var gun: VehicleGun = node as VehicleGun
		if gun != null and not gun.fired.is_connected(_on_fired):
			gun.fired.connect(_on_fired.bind(gun))


func _on_fired(
	p_ammunition: Ammunition, _position: Vector3, p_velocity: Vector3, p_gun: VehicleGun
) -> void:
	if not is_instance_valid(_controls.seat) or _controls.vehicle != p_gun.vehicle:
		return
	var mass: float = p_gun.vehicle.parameters.mass
	var jolt: Vector3 = -p_velocity.normalized() * p_ammunition.recoil() / mass / KICK_S
	_cues.get_forces().kick(_controls.seat.global_basis.inverse() * jolt)
