@tool
class_name StudioPreview
extends TextureRect
## Shows an effect over ground, from a camera that the mouse turns: drag to turn, wheel to come
## closer. Two texts can be compared side by side.

const GROUND: Color = Color(0.35, 0.3, 0.24)
const SKY: Color = Color(0.45, 0.55, 0.68)
const MAX_DISTANCE: float = 80.0
## Distance between two effects that are compared, m.
const APART: float = 3.0

## The effect that is edited.
var effect: ParticleEffect = ParticleEffect.new()
## The one that it is compared with; null for none.
var other: ParticleEffect = null
## What is drawn; a [SubViewport] of the size of this control.
var view: SubViewport = SubViewport.new()
## Simulated seconds a second while it is not paused.
var speed: float = 1.0:
	set(p_value):
		speed = p_value
		_apply_speed()
var paused: bool = false:
	set(p_value):
		paused = p_value
		_apply_speed()
## Speed of the wind, m/s, along X.
var wind: float = 0.0:
	set(p_value):
		wind = p_value
		RenderingServer.global_shader_parameter_set(&"wind", Vector3(wind, 0.0, 0.0))
## Speed of the emitter along X and back again, m/s; 0 stands still.
var travel: float = 0.0

var _camera: Camera3D = Camera3D.new()
var _ground: MeshInstance3D = MeshInstance3D.new()
var _azimuth: float = 0.3
var _elevation: float = 0.2
var _distance: float = 6.0
var _steps: int = 0
var _replay_s: float = 0.0
var _travelled: float = 0.0


func _init() -> void:
	expand_mode = TextureRect.EXPAND_IGNORE_SIZE
	mouse_filter = Control.MOUSE_FILTER_STOP
	clip_contents = true
	_build()
	add_child(view)
	texture = view.get_texture()
	resized.connect(_on_resized)


func _process(p_delta: float) -> void:
	if _steps > 0:
		_steps -= 1
		if _steps == 0:
			_apply_speed()
	var scaled: float = p_delta * _speed_now()
	_move_emitter(scaled)
	_replay(scaled)


func _gui_input(p_event: InputEvent) -> void:
	var motion: InputEventMouseMotion = p_event as InputEventMouseMotion
	if motion != null and motion.button_mask & (MOUSE_BUTTON_MASK_LEFT | MOUSE_BUTTON_MASK_RIGHT):
		_azimuth -= motion.relative.x * 0.008
		_elevation = clampf(_elevation + motion.relative.y * 0.006, -0.1, 1.5)
		_aim()
	var button: InputEventMouseButton = p_event as InputEventMouseButton
	if button != null and button.pressed:
		if button.button_index == MOUSE_BUTTON_WHEEL_UP:
			set_distance(_distance * 0.88)
		elif button.button_index == MOUSE_BUTTON_WHEEL_DOWN:
			set_distance(_distance / 0.88)


## Shows a file without problems. Particles that are under way go on where only the code changed.
func show_file(p_file: EffectFile) -> void:
	effect.show_file(p_file)
	if effect.one_shot and not effect.emitting:
		effect.restart()


## Compares with another file; null ends it.
func compare(p_file: EffectFile) -> void:
	if other != null:
		other.queue_free()
		other = null
	if p_file != null:
		other = ParticleEffect.new()
		other.show_file(p_file)
		other.position.x = APART * 0.5
		view.add_child(other)
	effect.position.x = -APART * 0.5 if other != null else 0.0
	_apply_speed()


## Plays it from the beginning.
func restart() -> void:
	effect.restart()
	if other != null:
		other.restart()


## One step of a sixtieth of a second while it is paused.
func step() -> void:
	paused = true
	_steps = 2
	effect.speed_scale = 1.0
	if other != null:
		other.speed_scale = 1.0


## How far the camera is from the effect, m.
func set_distance(p_metres: float) -> void:
	_distance = clampf(p_metres, 0.5, MAX_DISTANCE)
	_aim()


func set_ground(p_is_there: bool) -> void:
	_ground.visible = p_is_there


## The camera, for what depends on it.
func camera() -> Camera3D:
	return _camera


func _build() -> void:
	view.own_world_3d = true
	view.size = Vector2i(320, 240)
	view.render_target_update_mode = SubViewport.UPDATE_ALWAYS
	var world: WorldEnvironment = WorldEnvironment.new()
	world.environment = Environment.new()
	world.environment.background_mode = Environment.BG_COLOR
	world.environment.background_color = SKY
	world.environment.ambient_light_source = Environment.AMBIENT_SOURCE_COLOR
	world.environment.ambient_light_color = Color(0.6, 0.65, 0.7)
	view.add_child(world)
	var sun: DirectionalLight3D = DirectionalLight3D.new()
	sun.basis = Basis.looking_at(-Vector3(0.45, 0.8, 0.4))
	view.add_child(sun)
	var plane: PlaneMesh = PlaneMesh.new()
	plane.size = Vector2(600.0, 600.0)
	var paint: StandardMaterial3D = StandardMaterial3D.new()
	paint.albedo_color = GROUND
	plane.material = paint
	_ground.mesh = plane
	view.add_child(_ground)
	view.add_child(_camera)
	view.add_child(effect)
	_aim()


func _aim() -> void:
	var direction: Vector3 = Vector3.BACK.rotated(Vector3.RIGHT, -_elevation)
	direction = direction.rotated(Vector3.UP, _azimuth)
	var target: Vector3 = Vector3(0.0, minf(0.18 * _distance, 2.5), 0.0)
	var eye: Vector3 = target + direction * _distance
	_camera.transform = Transform3D(Basis.looking_at(-direction), eye)


func _speed_now() -> float:
	return 0.0 if paused and _steps == 0 else speed


func _apply_speed() -> void:
	effect.speed_scale = _speed_now()
	if other != null:
		other.speed_scale = _speed_now()


func _move_emitter(p_delta: float) -> void:
	_travelled += travel * p_delta
	var side: float = -APART * 0.5 if other != null else 0.0
	effect.position.x = side + 3.0 * sin(_travelled / 3.0) * signf(absf(travel))


## What plays once plays again after a pause.
func _replay(p_delta: float) -> void:
	if effect.layer == null or not effect.one_shot:
		_replay_s = 0.0
		return
	_replay_s += p_delta
	if _replay_s > effect.lifetime * (2.0 - effect.explosiveness) + 0.6:
		_replay_s = 0.0
		restart()


func _on_resized() -> void:
	view.size = Vector2i(maxi(int(size.x), 16), maxi(int(size.y), 16))
