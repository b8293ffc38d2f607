class_name ClientSeat
extends Node
## What this client's user does and sees in the seat of a vehicle: controls, views, instruments, and
## what hands and motion platform feel.

var _controls: SeatControls = SeatControls.new()
var _cues: ClientCues = ClientCues.new()
var _prediction: DriverPrediction = DriverPrediction.new()


func _init() -> void:
	add_child(_cues)
	add_child(_controls)
	add_child(_prediction)


func _physics_process(_delta: float) -> void:
	_cues.get_forces().wheel_position = -_controls.input.steer


## Begins as the options say. Returns what is wrong, or an empty text.
func open(p_scene: ClientScene, p_hud: Hud, p_options: Options) -> String:
	var drive: String = p_options.text("drive")
	if drive != "":
		_controls.list = DriveScript.parse(drive)
		if _controls.list.error != "":
			return _controls.list.error
	_controls.view_changed.connect(p_scene.look_through)
	_controls.told.connect(p_hud.show_news)
	if DisplayServer.get_name() != "headless":
		var hud: VehicleHud = (
			preload("res://scenes/vehicle/controls/vehicle_hud.tscn").instantiate()
		)
		add_child(hud)
		hud.follow(_controls)
	return _cues.open(p_options)


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


## What is predicted, for a report.
func report() -> Dictionary:
	return _prediction.report()


## What the user does in the seat.
func get_controls() -> SeatControls:
	return _controls
