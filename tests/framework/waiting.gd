class_name Waiting
extends RefCounted
## The one way of tests and benchmarks to wait for what other threads, sockets or frames bring.

## How long anything may take on a busy machine, s.
const PATIENCE_S: float = 60.0


## Waits, frame by frame, until something holds; returns whether it does within the limit, s.
## [param p_step], where it is given, is called (and awaited) before each look.
static func until(
	p_tree: SceneTree,
	p_holds: Callable,
	p_step: Callable = Callable(),
	p_limit_s: float = PATIENCE_S
) -> bool:
	var limit: int = Time.get_ticks_msec() + int(p_limit_s * 1000.0)
	while true:
		if p_step.is_valid():
			await p_step.call()
		if p_holds.call():
			return true
		if Time.get_ticks_msec() >= limit:
			return false
		await p_tree.process_frame
	return false
