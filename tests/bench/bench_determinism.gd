extends SceneTree
## Whether the same motion leads to the same state: a fingerprint of people among crates.
##
## Options: --bvh=FILE, --people=4, --hz=60, --seconds=5 (simulated),
## --root=soft|inertial|grounded. The fingerprint (48 bits of all bodies' places and velocities) is
## the same in every process on a machine. A second session in one process differs: the engine
## counts its bodies on.

const _CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
const _ROOTS: Dictionary[String, RagdollMotor.RootMode] = {
	"soft": RagdollMotor.ROOT_SOFT,
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"grounded": RagdollMotor.ROOT_GROUNDED,
}

var _arguments: BenchArguments = null


func _initialize() -> void:
	_arguments = (
		BenchArguments
		. parse(
			OS.get_cmdline_user_args(),
			{
				"bvh": "res://assets/motion/01_01.bvh",
				"people": 4,
				"hz": 60,
				"seconds": 5.0,
				"root": "soft",
			}
		)
	)
	_run.call_deferred()


func _run() -> void:
	var source: BvhSource = BvhSource.new()
	var fault: String = _arguments.error
	if fault == "" and not _ROOTS.has(_arguments.value("root")):
		fault = "a root is soft or inertial, found '%s'" % _arguments.value("root")
	if fault == "" and (_arguments.value("people") < 1 or _arguments.value("people") > 256):
		fault = "--people is between 1 and 256, found %d" % _arguments.value("people")
	if fault == "":
		source.open(_arguments.value("bvh"))
		fault = source.error
	if fault != "":
		printerr(fault)
		quit(2)
		return
	Engine.physics_ticks_per_second = _arguments.value("hz")
	var report: BenchReport = BenchReport.new("determinism", _arguments.value("json"))
	var name: String = "%d people, %s" % [_arguments.value("people"), _arguments.value("root")]
	report.add(name, "fingerprint", await _play(source), "")
	quit(report.finish())


func _play(p_source: BvhSource) -> int:
	var view: SubViewport = SubViewport.new()
	view.own_world_3d = true
	root.add_child(view)
	var ground: Block = Block.new()
	ground.size = Vector3(60.0, 1.0, 60.0)
	ground.position.y = -0.5
	view.add_child(ground)
	for i: int in 6:
		var crate: RigidBody3D = _CRATE.instantiate()
		crate.position = Vector3(0.3 * i, 0.25 + 0.5 * (i % 2), 0.8 + 0.2 * i)
		view.add_child(crate)
	var people: Array[Ragdoll] = []
	for i: int in _arguments.value("people"):
		var person: Ragdoll = (load("res://scenes/actor/soldier.tscn") as PackedScene).instantiate()
		person.root_mode = _ROOTS[_arguments.value("root")]
		view.add_child(person)
		person.start()
		people.append(person)
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	for tick: int in int(_arguments.value("seconds") / delta):
		await physics_frame
		for i: int in people.size():
			var sample: PoseSample = p_source.pose_at(tick * delta + 0.5 * i)
			var place: Vector3 = sample.root + Vector3(0.7 * i, 0.0, 0.0)
			people[i].push_sample(tick * delta, sample, place)
			people[i].drive(tick * delta, delta)
	await physics_frame
	var fingerprint: int = 0
	for person: Ragdoll in people:
		fingerprint = fingerprint * 31 + person.motor.get_state_hash()
	view.queue_free()
	await process_frame
	return fingerprint & 0xFFFFFFFFFFFF
