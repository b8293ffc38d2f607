extends Bench
## What becomes of people who fall onto a thin floor from a great height.
##
## Options: --bvh=FILE (whose poses they fall in, again for more; default the clips in
## assets/motion), --count=100, --root=grounded, --floor=0.1 (thickness, m), --hz=60, --seed=1.
## Every second one is limp.

const _SETTLE_S: float = 3.0
const _APART_M: float = 6.0
const _AT_ONCE: int = 10
## How deep a limb that lies on the floor may be in it, mm.
const _DEEP_MM: float = 30.0


func options() -> Dictionary:
	return {
		"bvh": "",
		"count": [100, 1, 10000],
		"root": ["grounded", RootModes.BY_NAME.keys()],
		"floor": 0.1,
		"hz": [60, 10, 1000],
		"seed": 1,
		"list": false,
	}


func measure() -> void:
	Engine.physics_ticks_per_second = option("hz")
	var sources: Array[BvhSource] = []
	for file: String in BenchArguments.clips(arguments):
		var source: BvhSource = report.open_clip(file)
		if source != null:
			sources.append(source)
	if sources.is_empty():
		return
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = option("seed")
	var rows: Dictionary[bool, PackedFloat64Array] = {}
	var left: int = option("count")
	while left > 0:
		await _drop(mini(left, _AT_ONCE), sources, random, rows)
		left -= _AT_ONCE
	for is_limp: bool in rows:
		_tell("limp" if is_limp else "driven", rows[is_limp])


## Lets some fall side by side. Each adds to the rows: limbs that are through, depth, the greatest
## depth on the way.
func _drop(
	p_count: int,
	p_sources: Array[BvhSource],
	p_random: RandomNumberGenerator,
	r_rows: Dictionary[bool, PackedFloat64Array]
) -> void:
	var world: ContactWorld = ContactWorld.new(option("hz"))
	root.add_child(world)
	var thick: float = option("floor")
	world.add_block(
		Vector3(200.0, thick, 200.0), Transform3D(Basis(), Vector3.DOWN * thick / 2.0), 0.6
	)
	var bodies: Array[DropBody] = []
	for i: int in p_count:
		var body: DropBody = DropBody.new()
		body.is_limp = i % 2 == 0
		body.origin = Vector3(i % 5, 0.0, i / 5) * _APART_M
		var source: BvhSource = p_sources[p_random.randi() % p_sources.size()]
		body.choose(source, p_random)
		body.person = ContactPerformer.new(source, false, {}).enter(world, root_mode())
		world.add_person(body.person, body.pose_at, body.place_at)
		bodies.append(body)
	await world.run(0.1)
	for body: DropBody in bodies:
		body.let_go()
	await world.run(DropBody.BEGIN_M / 20.0 + _SETTLE_S)
	for body: DropBody in bodies:
		var row: PackedFloat64Array = r_rows.get(body.is_limp, PackedFloat64Array())
		row.append_array([body.count_through(), body.depth()])
		r_rows[body.is_limp] = row
		if option("list") and (body.count_through() > 0 or body.depth() > 0.03):
			printerr("limp %s: %d through, %.3f deep" % [body.is_limp, row[-2], row[-1]])
	world.queue_free()
	await process_frame


func _tell(p_case: String, p_rows: PackedFloat64Array) -> void:
	var through: int = 0
	var limbs: int = 0
	var deepest: float = 0.0
	for i: int in p_rows.size() / 2:
		through += 1 if p_rows[2 * i] > 0.0 else 0
		limbs += roundi(p_rows[2 * i])
		deepest = maxf(deepest, p_rows[2 * i + 1])
	report.add(p_case, "fallen", p_rows.size() / 2, "")
	report.at_most(p_case, "with a limb in or under the floor", through, "", 0.0)
	report.at_most(p_case, "limbs in or under the floor", limbs, "", 0.0)
	report.at_most(p_case, "deepest at the end", 1000.0 * deepest, "mm", _DEEP_MM)
