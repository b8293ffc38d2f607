class_name ClientSeat
extends Node
## What this client's user does and sees in the seat of a vehicle: controls, views, instruments, and
## what hands and motion platform feel.

## A gun's recoil is over in so long, s.
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


## Begins as the options say; [param p_has_body]: for a user with a body of his own. Returns what is
## wrong, or an empty text.
func open(p_scene: ClientScene, p_hud: Hud, p_options: Options, p_has_body: bool) -> String:
	var drive: String = p_options.text("drive")
	if drive != "":
		_controls.list = DriveScript.parse(drive)
		if _controls.list.error != "":
			return _controls.list.error
	_controls.has_body = p_has_body
	_controls.view_changed.connect(p_scene.look_through)
	_controls.told.connect(p_hud.show_news)
	_controls.seat_changed.connect(_on_seat_changed)
	if DisplayServer.get_name() != "headless":
		var hud: VehicleHud = (
			preload("res://scenes/vehicle/controls/vehicle_hud.tscn").instantiate()
		)
		add_child(hud)
		hud.follow(_controls)
		_panel = preload("res://scenes/vehicle/controls/axis_panel.tscn").instantiate()
		add_child(_panel)
	return _cues.open(p_options)


## Hands feel the guns of the vehicle: no position shows such a jolt.
func _on_seat_changed(p_seat: Seat) -> void:
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


## Opens where a wheel and pedals are calibrated.
func show_wheel_panel() -> void:
	if _panel != null:
		_panel.show_panel(_controls.reader.settings)


## Has the vehicle obey the driver at once, on a connection to a server.
func predict(p_stream: LiveStream, p_replica: WorldReplica) -> void:
	_prediction.follow(
		_controls,
		p_replica,
		p_stream.now_s,
		func() -> int: return p_stream.link.clock.round_trip_usec
	)


## Has the replica show what is predicted. Call it before the replica is evaluated.
func apply_prediction() -> void:
	_prediction.apply()


## Tells a frame where the motion platform is that the user sits on.
func tell_platform(p_frame: PlatformFrame) -> void:
	_cues.tell_platform(p_frame)


## Says whether keys are meant for the window's menu.
func set_menu_open(p_is_open: bool) -> void:
	_controls.hands_off = p_is_open or (_panel != null and _panel.visible)


## What is predicted, for a report.
func report() -> Dictionary:
	return _prediction.report()
