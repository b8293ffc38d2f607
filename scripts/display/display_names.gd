class_name DisplayNames
extends RefCounted
## The values of the option [code]--display[/code]. They are not in the displays' own classes
## because every program reads its options, also one without a display.

## The client's window alone.
const WINDOW: String = "window"
## A headset by OpenXR.
const HMD: String = "hmd"
## The screens of a layout file.
const WALL: String = "wall"
## Stereo modes, in the order of [enum StereoMode.Kind].
const EYES: Array[String] = [
	"mono",
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


## Both eyes without a headset.
static func stereo() -> PackedStringArray:
	return EYES.slice(1)


## All of them.
static func all() -> PackedStringArray:
	return PackedStringArray([WINDOW, HMD, WALL]) + stereo()
