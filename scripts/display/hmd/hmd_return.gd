class_name HmdReturn
extends RefCounted
## The way into the headset, and back into it: asks the runtime now and then, and starts the program
## again with the headset as soon as one can be had.

## How often a runtime that was lost is asked, s, and how long an answer may take, s: it comes
## within 50 ms, but on a machine that is busy elsewhere.
const _PERIOD_S: float = 2.0
const PATIENCE_S: float = 8.0

## What the last answer was, one of [enum RuntimeProbe.Answer].
var answer: RuntimeProbe.Answer = RuntimeProbe.NONE

var _probe: RuntimeProbe = RuntimeProbe.new()
var _command: HmdCommand = null
var _wait_s: float = 0.0
var _tries: int = 0


func _init(p_command: HmdCommand) -> void:
	_command = p_command


## Asks the machine's runtime at once, and waits for what it says: at the start of the program,
## before anything is shown. Returns what is wrong and how to mend it, or an empty text.
func ask() -> String:
	var manifest: RuntimeManifest = RuntimeManifest.find()
	if manifest.error != "":
		return manifest.error
	_probe.start(manifest.library, PATIENCE_S)
	while _probe.poll() == RuntimeProbe.PENDING:
		OS.delay_msec(2)
	answer = _probe.poll()
	return explain(answer, manifest)


## A frame of a window that waits for the headset. Returns whether it can be had again.
func advance(p_delta: float) -> bool:
	if answer != RuntimeProbe.PENDING:
		_wait_s += p_delta
		if _wait_s < _PERIOD_S * (1 << mini(_tries / 8, 3)):
			return false
		_wait_s = 0.0
		_tries += 1
		var manifest: RuntimeManifest = RuntimeManifest.find()
		if manifest.error != "" or not _probe.start(manifest.library, PATIENCE_S):
			return false
	answer = _probe.poll()
	return answer == RuntimeProbe.READY


## Starts the program again, with the headset. Returns only where that fails: why.
func enter() -> String:
	OS.set_environment(HmdCommand.TRIED, "1")
	OS.unset_environment(HmdCommand.LOST)
	StallGuard.replace(_command.with_headset())
	return "the program could not be started again for the headset: start it with --xr-mode on"


## An answer in words: what is wrong and how to mend it; empty where nothing is.
static func explain(p_answer: RuntimeProbe.Answer, p_manifest: RuntimeManifest) -> String:
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
				% roundi(PATIENCE_S)
			)
	return "the OpenXR runtime was not asked: the system made no process for that"
