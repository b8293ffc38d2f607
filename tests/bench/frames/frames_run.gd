extends "res://tests/bench/smoothing/smoothing_run.gd"
## One client that watches a person on a display of any rate.

const Display: GDScript = preload("frames_display.gd")

var _smoother: SnapshotSmoother = SnapshotSmoother.new()


## Watches a motion.
func watch_on(p_motion: Motion, p_display: Display) -> void:
	motion = p_motion
	display_rate = p_display.rate
	var skeleton: PersonSkeleton = motion.skeleton
	_smoother.set_skeleton(0, skeleton.parents, skeleton.joints_in_parent, skeleton.joints_in_limb)
	p_display.play(_smoother, float(motion.count) / Motion.RATE - 0.1, _push, _show)


func _push(p_tick: int, p_arrival_s: float) -> void:
	var sample: int = roundi(Display.sampled_s(p_tick) * Motion.RATE)
	_smoother.push_person(0, p_tick, p_arrival_s, motion.roots[sample], motion.turns_of(sample))


func _show(p_time_s: float) -> void:
	_note(p_time_s, _smoother.person_transforms(0))
