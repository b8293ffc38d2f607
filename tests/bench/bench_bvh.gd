extends SceneTree
## Times reading, preparing, sampling and writing of the BVH clips in assets/motion.
##
## [codeblock lang=text]
## godot --headless --path . -s tests/bench/bench_bvh.gd
## [/codeblock]

const FOLDER: String = "res://assets/motion"
const ROUNDS: int = 5


func _initialize() -> void:
	for file: String in DirAccess.get_files_at(FOLDER):
		if file.get_extension() == "bvh":
			_time_file(FOLDER.path_join(file))
	quit()


func _time_file(p_path: String) -> void:
	var best: Array[float] = [INF, INF, INF, INF]
	var clip: BvhClip = null
	for _round: int in ROUNDS:
		var at: int = Time.get_ticks_usec()
		clip = BvhParser.parse_file(p_path).clip
		at = _note(best, 0, at)
		clip.prepare()
		at = _note(best, 1, at)
		var pose: BvhPose = BvhPose.new()
		for sample: int in 600:
			clip.sample_at(sample / 60.0, pose)
		at = _note(best, 2, at)
		BvhWriter.to_text(clip)
		_note(best, 3, at)
	print(
		(
			"%s: %d frames of %d numbers: parse %.0f ms, prepare %.0f ms, sample %.1f us, write %.0f ms"
			% (
				[p_path.get_file(), clip.frame_count, clip.channel_count]
				+ [best[0], best[1], best[2] / 600.0 * 1000.0, best[3]]
			)
		)
	)


func _note(p_best: Array[float], p_index: int, p_since: int) -> int:
	p_best[p_index] = minf(p_best[p_index], (Time.get_ticks_usec() - p_since) * 0.001)
	return Time.get_ticks_usec()
