extends Bench
## Whether the same motion leads to the same state: a fingerprint of people among crates.
##
## Options: --bvh=FILE, --people=4, --hz=60, --seconds=5 (simulated),
## --root=soft|inertial|grounded. The fingerprint (48 bits of all bodies' places and velocities) is
## the same in every process on a machine. A second session in one process differs: the engine
## counts its bodies on.

const _CRATE: PackedScene = preload("res://scenes/world/props/crate.tscn")
const _ROOTS: Array[String] = ["soft", "inertial", "grounded"]


func options() -> Dictionary:
	return {
		"bvh": "res://assets/motion/01_01.bvh",
		"people": [4, 1, 256],
		"hz": [60, 10, 1000],
		"seconds": 5.0,
		"root": ["soft", _ROOTS],
	}


func measure() -> void:
	Engine.physics_ticks_per_second = option("hz")
	var source: BvhSource = report.open_clip(option("bvh"))
	if source != null:
		var name: String = "%d people, %s" % [option("people"), option("root")]
		report.add(name, "fingerprint", await _play(source), "")


func _play(p_source: BvhSource) -> int:
	var view: SubViewport = SubViewport.new()
	view.own_world_3d = true
	root.add_child(view)
	view.add_child(BenchBodies.ground())
	for i: int in 6:
		var crate: RigidBody3D = _CRATE.instantiate()
		crate.position = Vector3(0.3 * i, 0.25 + 0.5 * (i % 2), 0.8 + 0.2 * i)
		view.add_child(crate)
	var people: Array[Ragdoll] = []
	for i: int in option("people"):
		var person: Ragdoll = BenchBodies.soldier(root_mode())
		view.add_child(person)
		person.start()
		people.append(person)
	var delta: float = 1.0 / Engine.physics_ticks_per_second
	for tick: int in int(option("seconds") / delta):
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
