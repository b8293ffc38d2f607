class_name RendererChoice
extends RefCounted
## Which renderer of the engine draws: where a processor has to draw, OpenGL
## ([code]gl_compatibility[/code]) takes a twelfth of the time that Vulkan in software does, so that
## what drivers a machine happens to have does not decide.
##
## The engine chooses before any script runs: another choice starts the program again, in the same
## process.

## What [code]--renderer[/code] can be; auto leaves it to this class.
const NAMES: PackedStringArray = ["auto", "gl_compatibility", "mobile", "forward_plus"]
const AUTO: String = "auto"
## Set in the process that was started again for its renderer: it does not try a second time.
const TRIED: String = "DISMOUNT_RENDERER_TRIED"
const _SOFTWARE: String = "gl_compatibility"


## The renderer that a program should draw with: what its option names, else what its start named to
## the engine, else what is best. [param p_current] is the present one,
## [param p_draws_by_processor] whether a processor draws.
static func choose(
	p_option: String, p_asked: String, p_current: String, p_draws_by_processor: bool
) -> String:
	if p_option != AUTO:
		return p_option
	if p_asked != "":
		return p_current
	return _SOFTWARE if p_draws_by_processor else p_current


## Starts this program again where another renderer should draw. Returns where it need not, or
## cannot.
static func apply(p_option: String) -> void:
	if DisplayServer.get_name() == "headless" or OS.has_feature("movie"):
		return
	if OS.has_environment(TRIED) or OS.has_environment(HmdCommand.TRIED):
		return
	var current: String = RenderingServer.get_current_rendering_method()
	var command: HmdCommand = HmdCommand.of_this_process()
	var chosen: String = choose(p_option, command.renderer, current, Quality.draws_by_processor())
	if chosen == current:
		return
	Log.info(
		"app",
		(
			"%s draws with %s instead of %s: the program starts again"
			% [RenderingServer.get_video_adapter_name(), chosen, current]
		)
	)
	OS.set_environment(TRIED, "1")
	command.renderer = chosen
	var error: Error = StallGuard.replace(command.with_window())
	OS.unset_environment(TRIED)
	Log.warning("app", "the program cannot start again: %s" % error_string(error))
