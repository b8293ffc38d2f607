class_name WorldView
extends ClientPart
## Shows the world at the moment of the frame: its views, the camera, and the user's own bodies as
## the user moves them.

var _fade: PhysicsFade = PhysicsFade.new()


func open(p_context: ClientContext) -> String:
	super(p_context)
	var options: Options = context.options
	context.scene.avatars.keep(options.text("avatar"))
	var fault: String = context.scene.apply(options.text("views"), options.text("camera"))
	context.scene.replica.table.spawned.connect(_on_spawned)
	return _fade.set_from_text(options.text("physics-at")) if fault == "" else fault


func advance(_delta_s: float) -> void:
	var stream: StateStream = context.stream
	context.scene.fade_physics(_fade, stream.now_s() - context.begin_s)
	if context.options.text("feedback") == "server":
		context.own_bodies.clear()
	elif context.people != null and context.own_bodies.has(context.people.first_actor):
		context.stats.own_shown(context.people.shown_moment_usec(context.frame_usec))
	context.scene.update(stream.frame_s(context.frame_usec), context.own_bodies, context.agreement)


func _on_spawned(p_row: EntityRow) -> void:
	if context.people == null or not p_row.is_person() or p_row.owner != context.stream.session():
		return
	context.people.embody(context.scene.replica, context.scene.people())
	context.scene.follow_own(context.people.first_actor, context.options.text("camera") == "")
