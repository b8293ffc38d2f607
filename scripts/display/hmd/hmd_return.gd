class_name HmdReturn
extends RefCounted
## The way into the headset, and back into it: asks the runtime now and then, and starts the program
## again with the headset as soon as one can be had.
##
## Only [method ask] waits for an answer, at the start of the program; [method advance] never does.
## A runtime that does not answer is asked less and less often: what asks is a process of its own.

## The program starts again with the headset now: what should be ended in order ends here.
signal leaving

## How often the runtime is asked at first, s; and after how many answers half as often, thrice at
## most.
const PERIOD_S: float = 2.0
const _ANSWERS: int = 8
## How long an answer may take, s: it comes within 50 ms, but on a machine that is busy elsewhere.
const PATIENCE_S: float = 8.0
## How long the start of the program waits for it, s.
const START_S: float = 3.0

## What the last answer was, one of [enum RuntimeProbe.Answer].
var answer: RuntimeProbe.Answer = RuntimeProbe.NONE
## What is wrong by the last answer and how to mend it; empty where a headset can be had.
var fault: String = ""

var _probe: RuntimeProbe = RuntimeProbe.new()
var _manifest: RuntimeManifest = RuntimeManifest.new()
var _command: HmdCommand = null
var _wait_s: float = 0.0
var _answers: int = 0


func _init(p_command: HmdCommand) -> void:
	_command = p_command


## Asks the machine's runtime at once, and waits for what it says, but not for long: at the start
## of the program, before anything is shown. A later answer comes by [method advance]. Returns what
## is wrong and how to mend it, or an empty text.
func ask() -> String:
	if not begin():
		return fault
	var until: int = Time.get_ticks_usec() + roundi(START_S * 1e6)
	while _probe.poll() == RuntimeProbe.PENDING and Time.get_ticks_usec() < until:
		OS.delay_msec(2)
	if not _take_answer():
		return explain(RuntimeProbe.STALLED, _manifest, START_S)
	return fault


## Asks the runtime, without waiting for its answer. Returns false where it cannot be asked: then
## [member fault] says why.
func begin() -> bool:
	_wait_s = 0.0
	if answer == RuntimeProbe.PENDING:
		return true
	_manifest = RuntimeManifest.find()
	if _manifest.error == "" and _probe.start(_manifest.library, PATIENCE_S):
		answer = RuntimeProbe.PENDING
		return true
	answer = RuntimeProbe.NONE
	fault = _manifest.error
	if fault == "":
		fault = explain(answer, _manifest)
	_answers += 1
	return false


## A frame of a window that waits for the headset, s. Returns whether there is a new answer.
func advance(p_delta: float) -> bool:
	if answer == RuntimeProbe.PENDING:
		return _take_answer()
	_wait_s += p_delta
	if _wait_s < PERIOD_S * (1 << mini(_answers / _ANSWERS, 3)):
		return false
	return not begin()


## Whether a headset can be had by the last answer.
func is_ready() -> bool:
	return answer == RuntimeProbe.READY


## Starts the program again, with the headset. Returns only where that fails: why.
func enter() -> String:
	var why: String = "the program could not be started again: start it with --xr-mode on"
	if not _command.is_there():
		return why
	leaving.emit()
	var lost: String = OS.get_environment(HmdCommand.LOST)
	OS.set_environment(HmdCommand.TRIED, "1")
	OS.set_environment(HmdCommand.RENDERER, _command.renderer)
	OS.unset_environment(HmdCommand.LOST)
	StallGuard.replace(_command.with_headset())
	OS.unset_environment(HmdCommand.TRIED)
	OS.unset_environment(HmdCommand.RENDERER)
	if lost != "":
		OS.set_environment(HmdCommand.LOST, lost)
	return why


## An answer in words: what is wrong and how to mend it; empty where nothing is. Takes how long it
## was waited for, s.
static func explain(
	p_answer: RuntimeProbe.Answer, p_manifest: RuntimeManifest, p_waited_s: float = PATIENCE_S
) -> String:
	match p_answer:
		RuntimeProbe.READY:
			return ""
		RuntimeProbe.NO_LIBRARY:
			return (
				"%s, which %s names, cannot be loaded as an OpenXR runtime: install it anew"
				% [p_manifest.library, p_manifest.path]
			)
		RuntimeProbe.NO_SERVICE:
			return (
				"the OpenXR runtime of %s does not run: start it (SteamVR, or monado-service)"
				% p_manifest.path
			)
		RuntimeProbe.NO_HEADSET:
			return "the OpenXR runtime has no headset: plug it in and switch it on"
		RuntimeProbe.STALLED:
			return (
				"the OpenXR runtime does not answer within %d s: end it and start it again"
				% roundi(p_waited_s)
			)
	return "the OpenXR runtime was not asked: the system made no process for that"


func _take_answer() -> bool:
	answer = _probe.poll()
	if answer == RuntimeProbe.PENDING:
		return false
	_answers += 1
	fault = explain(answer, _manifest)
	return true
