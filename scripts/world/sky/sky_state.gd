@tool
class_name SkyState
extends RefCounted
## How sky, sun and air look at a time of day in a weather: everything that [WorldSky] sets,
## computed from the two. East is +X, south is +Z.

## Greatest height of the sun, at noon, rad.
const NOON_HEIGHT: float = deg_to_rad(65.0)
## Greatest height of the moon, at midnight, rad.
const MOON_HEIGHT: float = deg_to_rad(48.0)

## Heights of the sun for the colours below, degrees.
const _HEIGHTS: PackedFloat32Array = [-14.0, -8.0, -4.0, 0.0, 4.0, 12.0, 30.0, 65.0]
## Colours of the sky straight above, sRGB.
const _ZENITH: PackedColorArray = [
	Color(0.052, 0.075, 0.140),
	Color(0.070, 0.105, 0.205),
	Color(0.11, 0.17, 0.30),
	Color(0.16, 0.25, 0.43),
	Color(0.18, 0.30, 0.52),
	Color(0.17, 0.32, 0.59),
	Color(0.16, 0.33, 0.62),
	Color(0.16, 0.33, 0.62),
]
## Half way up.
const _MIDDLE: PackedColorArray = [
	Color(0.070, 0.092, 0.158),
	Color(0.12, 0.15, 0.25),
	Color(0.26, 0.29, 0.40),
	Color(0.44, 0.46, 0.54),
	Color(0.52, 0.58, 0.66),
	Color(0.50, 0.62, 0.76),
	Color(0.46, 0.62, 0.80),
	Color(0.46, 0.62, 0.80),
]
## At the horizon.
const _HORIZON: PackedColorArray = [
	Color(0.100, 0.115, 0.165),
	Color(0.18, 0.18, 0.24),
	Color(0.44, 0.36, 0.38),
	Color(0.74, 0.56, 0.46),
	Color(0.86, 0.70, 0.55),
	Color(0.88, 0.78, 0.63),
	Color(0.86, 0.80, 0.68),
	Color(0.86, 0.80, 0.68),
]
## Light of the sun, sRGB; black where it is below the horizon.
const _SUN: PackedColorArray = [
	Color(1.0, 0.45, 0.22),
	Color(1.0, 0.45, 0.22),
	Color(1.0, 0.48, 0.24),
	Color(1.0, 0.55, 0.30),
	Color(1.0, 0.68, 0.43),
	Color(1.0, 0.83, 0.64),
	Color(1.0, 0.93, 0.80),
	Color(1.0, 0.95, 0.85),
]
const _SUN_ENERGY: PackedFloat32Array = [0.0, 0.0, 0.0, 0.12, 0.75, 1.4, 1.6, 1.65]
## Glow of the horizon on the sun's side.
const _GLOW: PackedFloat32Array = [0.0, 0.12, 0.55, 0.9, 0.75, 0.35, 0.1, 0.0]

const _MOONLIGHT: Color = Color(0.60, 0.72, 1.0)
const _MOON_ENERGY: float = 0.17
## Light of lamps and torches, linear.
const _LAMPLIGHT: Vector3 = Vector3(1.0, 0.60, 0.27)
const _LAMP_ENERGY: float = 2.6
## From the mean radiance of the sky to what the baked light takes as 1.
const _SKY_GAIN: float = 1.75
## Share of the sun's light that open ground throws back upwards.
const _BOUNCE: float = 1.0

## Wind of a sandstorm, m/s.
const _STORM: Vector3 = Vector3(7.0, 0.0, 2.5)

## Towards the sun, and towards the moon.
var sun: Vector3 = Vector3.UP
var moon: Vector3 = Vector3.DOWN
## Towards the one that gives light now, its colour (sRGB) and its energy.
var light: Vector3 = Vector3.UP
var light_color: Color = Color.WHITE
var light_energy: float = 0.0
## Colours of the sky, linear: straight above, half way, at the horizon, below it.
var zenith: Color = Color.BLACK
var middle: Color = Color.BLACK
var horizon: Color = Color.BLACK
var ground: Color = Color.BLACK
## Colour of the horizon towards the low sun, linear, its strength included.
var glow: Color = Color.BLACK
## How much of the sky clouds cover and how dark they are, 0 to 1.
var cloud_cover: float = 0.35
var cloud_shade: float = 0.0
## How much of the discs of sun and moon is seen through the air, 0 to 1.
var clearness: float = 1.0
## How much is seen of the stars, 0 to 1.
var stars: float = 0.0
## Colour of distant things, linear, and share of light lost per m.
var fog_color: Color = Color.BLACK
var fog_density: float = 0.0
## How far shadows are softened by scattered light: opacity of the sun's shadow.
var shadow_opacity: float = 1.0
## Strength of the baked sources, linear: see light.gdshaderinc.
var sky_light: Vector3 = Vector3.ONE
var morning_light: Vector3 = Vector3.ZERO
var noon_light: Vector3 = Vector3.ZERO
var evening_light: Vector3 = Vector3.ZERO
var lamp_light: Vector3 = Vector3.ZERO
## How far lamps and torches are lit, 0 to 1.
var lamps: float = 0.0
## How wet everything outdoors is, 0 to 1.
var wetness: float = 0.0
## Amounts of falling rain and flying dust, 0 to 1.
var rain: float = 0.0
var dust: float = 0.0


## The state at an hour (0 to 24) with amounts of haze, dust and rain, each 0 to 1.
static func at(
	p_hours: float, p_haze: float = 0.0, p_dust: float = 0.0, p_rain: float = 0.0
) -> SkyState:
	var state: SkyState = SkyState.new()
	state.rain = p_rain
	state.dust = p_dust
	state.wetness = p_rain
	state.sun = direction_at(p_hours, NOON_HEIGHT)
	state.moon = direction_at(p_hours + 12.0, MOON_HEIGHT)
	state._set_clear_sky()
	state._add_weather(p_haze, p_dust, p_rain)
	state._set_baked_light(p_hours)
	return state


## Towards a body of the sky that is highest, at a height in rad, at 12 o'clock in the south.
static func direction_at(p_hours: float, p_height: float) -> Vector3:
	var turn: float = (p_hours - 12.0) / 12.0 * PI
	return Vector3(-sin(turn), cos(turn) * sin(p_height), cos(turn) * cos(p_height))


## The wind, m/s, in the world: a breeze, more in rain, a storm in flying dust.
func wind() -> Vector3:
	return Vector3(0.9, 0.0, 0.4).lerp(Vector3(1.8, 0.0, 0.8), rain).lerp(_STORM, dust)


func _set_clear_sky() -> void:
	var height: float = rad_to_deg(asin(clampf(sun.y, -1.0, 1.0)))
	zenith = _color_of(_ZENITH, height).srgb_to_linear()
	middle = _color_of(_MIDDLE, height).srgb_to_linear()
	horizon = _color_of(_HORIZON, height).srgb_to_linear()
	var energy: float = _number_of(_SUN_ENERGY, height)
	# The moon takes over while neither gives any light.
	var night: float = smoothstep(-0.07, -0.17, sun.y)
	light = sun if night <= 0.0 else moon
	light_color = _color_of(_SUN, height) if night <= 0.0 else _MOONLIGHT
	light_energy = energy if night <= 0.0 else _MOON_ENERGY * night * smoothstep(0.0, 0.2, moon.y)
	stars = smoothstep(-0.06, -0.22, sun.y)
	lamps = smoothstep(0.13, -0.03, sun.y)
	var strength: float = _number_of(_GLOW, height)
	glow = Color(1.0, 0.36, 0.11) * strength
	fog_density = 0.0015


func _add_weather(p_haze: float, p_dust: float, p_rain: float) -> void:
	# Even then one sees the hand before the eyes.
	var brightness: float = maxf(horizon.get_luminance(), 0.022)
	_veil(Color(0.98, 0.96, 0.90) * brightness * 1.05, p_haze, 0.80)
	_veil(Color(1.02, 0.66, 0.33) * brightness * 0.80, p_dust, 0.97)
	_veil(Color(0.86, 0.95, 1.02) * brightness * 0.42, p_rain, 0.95)
	fog_density += 0.0065 * p_haze + 0.026 * p_dust * p_dust + 0.004 * p_dust + 0.0055 * p_rain
	var through: float = (1.0 - 0.45 * p_haze) * (1.0 - 0.88 * p_dust) * (1.0 - 0.93 * p_rain)
	light_energy *= through
	light_color = light_color.lerp(Color(1.0, 0.78, 0.52), 0.6 * p_dust)
	clearness = (1.0 - 0.7 * p_haze) * (1.0 - p_dust) * (1.0 - p_rain)
	shadow_opacity = (1.0 - 0.25 * p_haze) * (1.0 - 0.5 * p_dust) * (1.0 - 0.4 * p_rain)
	stars *= clearness * clearness
	glow *= clearness
	cloud_cover = lerpf(0.35 * (1.0 - 0.8 * p_haze) * (1.0 - p_dust), 1.0, p_rain)
	cloud_shade = p_rain
	# Whoever sees little lights his lamps.
	lamps = maxf(lamps, smoothstep(0.3, 1.0, maxf(0.75 * p_dust, 0.5 * p_rain)))


## Covers the sky with a colour, least straight above.
func _veil(p_color: Color, p_amount: float, p_most: float) -> void:
	zenith = zenith.lerp(p_color * 0.82, p_amount * p_most * 0.92)
	middle = middle.lerp(p_color * 0.95, p_amount * p_most)
	horizon = horizon.lerp(p_color, p_amount * p_most)


func _set_baked_light(p_hours: float) -> void:
	var mean: Color = zenith * 0.25 + middle * 0.45 + horizon * 0.30
	# Light in the shade looks less blue to the eye than it is.
	var grey: float = mean.get_luminance()
	mean = mean.lerp(Color(grey, grey, grey), 0.35) * _SKY_GAIN
	# Air that takes the sun's light away scatters a part of it.
	sky_light = Vector3(mean.r, mean.g, mean.b)
	var sunlight: Color = light_color.srgb_to_linear() * light_energy * _BOUNCE
	var bounce: Vector3 = Vector3(sunlight.r, sunlight.g, sunlight.b)
	var early: float = clampf((12.0 - p_hours) / 5.0, 0.0, 1.0)
	var late: float = clampf((p_hours - 12.0) / 5.0, 0.0, 1.0)
	if sun.y < -0.07:
		# The moon's: it stands in the east, the south and the west in its turn, 12 h later.
		var moon_hours: float = fposmod(p_hours + 12.0, 24.0)
		early = clampf((12.0 - moon_hours) / 5.0, 0.0, 1.0)
		late = clampf((moon_hours - 12.0) / 5.0, 0.0, 1.0)
	morning_light = bounce * early
	evening_light = bounce * late
	noon_light = bounce * (1.0 - early - late)
	lamp_light = _LAMPLIGHT * (_LAMP_ENERGY * lamps)
	ground = horizon * Color(0.80, 0.66, 0.50)
	fog_color = horizon


static func _color_of(p_colors: PackedColorArray, p_height: float) -> Color:
	var place: float = _place_of(p_height)
	var index: int = mini(int(place), p_colors.size() - 2)
	return p_colors[index].lerp(p_colors[index + 1], place - index)


static func _number_of(p_numbers: PackedFloat32Array, p_height: float) -> float:
	var place: float = _place_of(p_height)
	var index: int = mini(int(place), p_numbers.size() - 2)
	return lerpf(p_numbers[index], p_numbers[index + 1], place - index)


## Place of a height of the sun, degrees, in the lists above.
static func _place_of(p_height: float) -> float:
	for index: int in _HEIGHTS.size() - 1:
		if p_height < _HEIGHTS[index + 1]:
			var part: float = inverse_lerp(_HEIGHTS[index], _HEIGHTS[index + 1], p_height)
			return index + maxf(part, 0.0)
	return _HEIGHTS.size() - 1.0
