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
## Both eyes without a headset. Rarer stereo modes are for the screens of a layout file.
const STEREO: PackedStringArray = ["side-by-side", "top-bottom", "anaglyph", "rows", "columns"]
## All values.
const ALL: PackedStringArray = [
	"window", "hmd", "wall", "side-by-side", "top-bottom", "anaglyph", "rows", "columns"
]
