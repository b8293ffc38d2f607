@tool
class_name EntityField
extends Resource
## One number of an entity that all clients know: a turret's angle, a door's opening, health.
##
## On the wire it is a whole number of steps of [member resolution] above [member min_value], so
## both ends agree on every value exactly.

## How a field behaves between two updates. Numbers are those of the wire.
enum Kind {
	## Interpolated the short way round; [member max_value] is the same angle as
	## [member min_value].
	ANGLE,
	## Interpolated like a position.
	LINEAR,
	## Never interpolated: it keeps its value until the tick at which it changes.
	STEP,
}

## Largest number of steps of a field: every one is exact as a float of 4 bytes.
const MAX_STEPS: int = 1 << 24

## Name of the field within its type.
@export var name: StringName = &"":
	set(p_value):
		name = p_value
		resource_name = p_value
## How it behaves between two updates.
@export var kind: Kind = Kind.LINEAR
## Lowest value.
@export var min_value: float = 0.0
## Highest value; of an angle, the value that wraps to [member min_value].
@export var max_value: float = 1.0
## Smallest difference between two values, in the unit of the field.
@export var resolution: float = 0.01
## Value of a new entity.
@export var default_value: float = 0.0


## A field, for types that are made by a script.
static func create(
	p_name: StringName,
	p_kind: Kind,
	p_min: float,
	p_max: float,
	p_resolution: float,
	p_default: float = 0.0
) -> EntityField:
	var field: EntityField = EntityField.new()
	field.name = p_name
	field.kind = p_kind
	field.min_value = p_min
	field.max_value = p_max
	field.resolution = p_resolution
	field.default_value = p_default
	return field


## A field that holds a whole number from 0 to a highest one.
static func create_count(p_name: StringName, p_max: int, p_default: int = 0) -> EntityField:
	return create(p_name, Kind.STEP, 0.0, p_max, 1.0, p_default)


## Number of steps between the lowest and the highest value.
func steps() -> int:
	return roundi((max_value - min_value) / resolution)


## The step that is nearest to a value: values out of range are clamped, angles wrap, and NaN
## counts as the lowest value.
func to_step(p_value: float) -> int:
	if not is_finite(p_value):
		return 0
	if kind == Kind.ANGLE:
		return posmod(
			roundi(fposmod(p_value - min_value, max_value - min_value) / resolution), steps()
		)
	return clampi(roundi((p_value - min_value) / resolution), 0, steps())


## The value of a step.
func from_step(p_step: int) -> float:
	return min_value + p_step * resolution


## The value that the other end restores when this one is sent.
func quantize(p_value: float) -> float:
	return from_step(to_step(p_value))


## Bytes of a step in a command, an event or a spawn.
func size() -> int:
	var highest: int = steps()
	return 1 if highest < 1 << 8 else (2 if highest < 1 << 16 else 4)


## Why this field is invalid and how to fix it, or an empty text.
func find_fault() -> String:
	if name == &"":
		return "a field has no name"
	# A comparison that NaN fails, too.
	if not (is_finite(min_value) and is_finite(max_value) and min_value < max_value):
		return "field '%s': the highest value must be above the lowest" % name
	if not (resolution > 0.0 and (max_value - min_value) / resolution <= MAX_STEPS):
		return "field '%s': the resolution must be above 0 and give at most 2^24 steps" % name
	if steps() < 1:
		return "field '%s': the resolution is coarser than the range" % name
	if not (default_value >= min_value and default_value <= max_value):
		return "field '%s': the default is out of range" % name
	return ""
