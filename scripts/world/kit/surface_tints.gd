class_name SurfaceTints
extends RefCounted
## Colours that the surfaces of blocks are tinted with: the second number of a block's style.

## Number of a tint.
enum Tint {
	## As the picture of the layer is.
	PLAIN,
	## Walls, from pale to reddish.
	CREAM,
	SAND,
	OCHRE,
	IVORY,
	ROSE,
	GREY_STONE,
	STRAW,
	PEACH,
	## Trims, sills and caps.
	TRIM_PALE,
	TRIM_BROWN,
	TRIM_WHITE,
	## Painted wood and metal.
	BLUE,
	SAGE,
	TAN,
	TURQUOISE,
	DARK_GREEN,
	RED,
	YELLOW,
	NAVY,
	WHITE,
	## Iron, copper, and what is nearly black.
	IRON,
	COPPER,
	BLACK,
	## Cloth.
	CLOTH_BLUE,
	CLOTH_OLIVE,
	CLOTH_WINE,
	## Leaves.
	LEAF,
	LEAF_DRY,
	## Tarnished by soot.
	SOOT,
	## Hazard orange.
	ORANGE,
	## What shines at night: the shade of a lamp.
	LAMP,
}

## The colours, sRGB, in the order of the tints. The shader has room for 32.
const COLOURS: Array[String] = [
	"ffffff",
	"f4ece0",
	"ece0cb",
	"e8d6bb",
	"f8f0e0",
	"ecd8c8",
	"d4d2c8",
	"e6d4b0",
	"f0dfcc",
	"d8cdb8",
	"c9b79c",
	"e6ddcc",
	"86a9b8",
	"8fae93",
	"cfae86",
	"6fb0ac",
	"5d7558",
	"b3503c",
	"e0b040",
	"4a6487",
	"f2efe6",
	"6a6460",
	"9fc4c0",
	"403c3a",
	"7f9fc8",
	"8a8a45",
	"8c4350",
	"8fa05a",
	"b8a868",
	"5a534c",
	"e0803c",
	"fff4d8",
]


## The colours of all tints, linear.
static func linear() -> PackedColorArray:
	var colours: PackedColorArray = []
	for text: String in COLOURS:
		colours.append(Color.from_string(text, Color.WHITE).srgb_to_linear())
	return colours


## The colours of all tints as a shader takes them.
static func srgb() -> PackedColorArray:
	var colours: PackedColorArray = []
	for text: String in COLOURS:
		colours.append(Color.from_string(text, Color.WHITE))
	return colours
