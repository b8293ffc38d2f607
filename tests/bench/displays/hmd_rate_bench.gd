extends SceneTree
## Ten simulated minutes at 90 Hz: which refreshes are missed where the cost of a picture grows with
## its pixels, rises by half for a minute in every four, and has rare spikes. Not a GPU: there is
## none where this was written.

const _RATE_HZ: float = 90.0
const _SECONDS: float = 600.0


func _init() -> void:
	# Cost of the whole picture and the part of it that does not depend on pixels, ms.
	var cases: Dictionary[String, Vector2] = {
		"fast card": Vector2(6.0, 2.0),
		"just too slow": Vector2(12.0, 3.0),
		"half as fast as needed": Vector2(20.0, 3.0),
	}
	for name: String in cases:
		_run(name, cases[name], false)
		_run(name + ", the card tells", cases[name], true)
	quit()


func _run(p_name: String, p_cost: Vector2, p_tells: bool) -> void:
	var random: RandomNumberGenerator = RandomNumberGenerator.new()
	random.seed = 90
	var keeper: RateKeeper = RateKeeper.new()
	var steps: Array[int] = [0]
	keeper.stepped.connect(func(_step: int) -> void: steps[0] += 1)
	var period: float = 1.0 / _RATE_HZ
	var now: float = 0.0
	while now < _SECONDS:
		var row: Dictionary = RateKeeper.STEPS[keeper.step]
		var pixels: float = float(row["scale"]) ** 2
		var edges: float = 1.0 if row["msaa"] == Viewport.MSAA_4X else 0.9
		var shadows: float = 1.0 if row["shadows"] else 0.8
		var busy: float = 1.5 if fmod(now, 240.0) > 180.0 else 1.0
		var cost: float = p_cost.y + (p_cost.x - p_cost.y) * pixels * edges * shadows
		cost *= busy * (1.0 + 0.03 * random.randfn())
		if random.randf() < 0.0005:
			cost += 12.0
		var frame: float = maxf(1.0, ceilf(cost / 1000.0 / period)) * period
		keeper.add(frame, period, cost / 1000.0 if p_tells else 0.0)
		now += frame
	var whole: Dictionary = {"case": "90 Hz simulated, " + p_name}
	var missed: Dictionary = whole.merged(
		{"metric": "missed refreshes in 10 min", "value": 100.0 * keeper.missed_share()}
	)
	print(JSON.stringify(missed.merged({"unit": "%", "goal": 1.0})))
	var changes: Dictionary = {"metric": "changes of the quality", "value": steps[0], "unit": ""}
	print(JSON.stringify(whole.merged(changes)))
