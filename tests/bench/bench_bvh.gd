extends Bench
## How fast motion files are read, prepared, sampled and written.
##
## Options: --bvh=FILE (again for more; default the clips in assets/motion), --rounds=5 (medians).
## The goal is for 3,000 frames of 30 joints; a file of another size is scaled to it by its numbers.

const _GOAL_MS: float = 1000.0
const _GOAL_NUMBERS: float = 3000.0 * 93.0
const _SAMPLES: int = 600


func options() -> Dictionary:
	return {"bvh": "", "rounds": [5, 1, 1000]}


func measure() -> void:
	for file: String in BenchArguments.clips(arguments):
		var fault: String = _time_file(file, option("rounds"), report)
		if fault != "":
			report.leave_out(file, fault)


## Returns why the file cannot be timed, or an empty text.
func _time_file(p_file: String, p_rounds: int, p_report: BenchReport) -> String:
	var times: Array[Statistics] = [
		Statistics.new(), Statistics.new(), Statistics.new(), Statistics.new()
	]
	var clip: BvhClip = null
	for _round: int in p_rounds:
		var begin: int = Time.get_ticks_usec()
		var result: BvhParser.Result = BvhParser.parse_file(p_file)
		if result.error != "":
			return result.error
		clip = result.clip
		begin = _note(times[0], begin)
		clip.prepare()
		begin = _note(times[1], begin)
		var pose: BvhClip.Pose = BvhClip.Pose.new()
		for sample: int in _SAMPLES:
			clip.sample_at(sample / 60.0, pose)
		begin = _note(times[2], begin)
		BvhWriter.to_text(clip)
		_note(times[3], begin)
	var name: String = "%s, %d x %d" % [p_file.get_file(), clip.frame_count, clip.channel_count]
	var parse: float = times[0].percentile(0.5)
	var scaled: float = parse * _GOAL_NUMBERS / maxf(clip.frame_count * clip.channel_count, 1.0)
	p_report.add(name, "parse", parse, "ms")
	p_report.at_most(name, "parse 3,000 x 30", scaled, "ms", _GOAL_MS)
	p_report.add(name, "prepare", times[1].percentile(0.5), "ms")
	p_report.add(name, "sample", times[2].percentile(0.5) * 1000.0 / _SAMPLES, "us")
	p_report.add(name, "write", times[3].percentile(0.5), "ms")
	return ""


static func _note(p_times: Statistics, p_begin: int) -> int:
	p_times.add((Time.get_ticks_usec() - p_begin) / 1000.0)
	return Time.get_ticks_usec()
