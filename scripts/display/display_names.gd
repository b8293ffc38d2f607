class_name DisplayNames
extends RefCounted
## What the option [code]--display[/code] can be. Apart from the displays themselves: every program
## reads its options, also one that shows nothing.

## The client's window alone.
const WINDOW: String = "window"
## A headset by OpenXR.
const HMD: String = "hmd"
## The screens of a layout file.
const WALL: String = "wall"
## Both eyes without a headset: the ways of [StereoMode].
const STEREO: Array[String] = [
	"side-by-side",
	"side-by-side-full",
	"top-bottom",
	"top-bottom-full",
	"anaglyph",
	"rows",
	"columns",
	"checkerboard",
	"windows",
	"left",
	"right",
]


## All of them.
static func all() -> PackedStringArray:
	return PackedStringArray([WINDOW, HMD, WALL] + STEREO)
