@tool
class_name UiStyle
extends RefCounted
## Colours and sizes of text of everything that a user reads, for what is drawn by code.
##
## Controls need none of it: the project's theme, scenes/ui/theme.tres, has the same values, and
## what differs from a plain control is a [member Control.theme_type_variation], named here.
## Contrast of text against its ground is at least 4.5, that of marks 3 (WCAG 2.1 AA).

## Text, and text that matters less.
const TEXT: Color = Color("eef2f6")
const DIM: Color = Color("b3bdc8")
## What has the keyboard, and what a slider or bar shows.
const ACCENT: Color = Color("6cb8f5")
## What is worth a look, is wrong, or is well.
const WARN: Color = Color("ffc45e")
const BAD: Color = Color("ff9483")
const GOOD: Color = Color("8be09a")
## The ground of a whole screen, of a panel, of a field to type in, and of a button.
const SCREEN: Color = Color("101418")
const SURFACE: Color = Color("171c22")
const FIELD: Color = Color("0d1013")
const RAISED: Color = Color("29323c")
## Of a button under the mouse.
const HOVER: Color = Color("364350")
## Edges of fields, and what lies behind a slider.
const EDGE: Color = Color("6f7d8c")

## Sizes of plain text and of a panel's title, px at a window of 1280 x 720.
const BODY_PX: int = 16
const TITLE_PX: int = 22
## Sizes of a choice of the start screen and of the name above them, px at a window of 1280 x 720.
const CHOICE_PX: int = 18
const HERO_PX: int = 44

## Variations of a [Label]: over a panel's rows, over a part of them, of less weight, of a fault.
const TITLE: StringName = &"UiTitle"
const HEADING: StringName = &"UiHeading"
const HINT: StringName = &"UiHint"
const WARNING: StringName = &"UiWarning"
## A [Label] over the world, with an outline, and a large one with a ground of its own.
const OVERLAY: StringName = &"UiOverlay"
const BANNER: StringName = &"UiBanner"
## A [PanelContainer] over others, with an edge.
const SHEET: StringName = &"UiSheet"
## Of the start screen: the margins of a screen (of a [MarginContainer]), its board and the column
## of choices (of [PanelContainer]), the program's name (of [Label]), a choice, and the one button
## that most users want (of [Button]).
const STAGE: StringName = &"UiStage"
const BOARD: StringName = &"UiBoard"
const COLUMN: StringName = &"UiColumn"
const HERO: StringName = &"UiHero"
const CHOICE: StringName = &"UiChoice"
const PRIMARY: StringName = &"UiPrimary"
## A [Button] with a large picture over its text.
const PICTURE: StringName = &"UiPicture"

## For screens with much on them, such as tables and tools: put it in [member Control.theme].
const DENSE: String = "res://scenes/ui/dense.tres"


## The contrast of two colours, 1 to 21: (L1 + 0.05) / (L2 + 0.05) of their relative luminances
## (WCAG 2.1, "contrast ratio"). Both must be opaque.
static func contrast(p_first: Color, p_second: Color) -> float:
	var first: float = _luminance(p_first)
	var second: float = _luminance(p_second)
	return (maxf(first, second) + 0.05) / (minf(first, second) + 0.05)


static func _luminance(p_colour: Color) -> float:
	var linear: Color = p_colour.srgb_to_linear()
	return 0.2126 * linear.r + 0.7152 * linear.g + 0.0722 * linear.b
