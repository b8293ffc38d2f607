@tool
class_name QualityTier
extends RefCounted
## What a tier of quality means for what is drawn.

## Name, for options and menus.
var name: String = ""
## Share of the window's pixels along each axis that the world is drawn with.
var render_scale: float = 1.0
## How edges are smoothed.
var msaa: Viewport.MSAA = Viewport.MSAA_DISABLED
## How pictures are filtered on surfaces that are seen from the side.
var anisotropy: Viewport.AnisotropicFiltering = Viewport.ANISOTROPY_4X
## By how many pixels a level of detail may be off.
var lod_pixels: float = 1.0
## Edge of the map of the sun's shadows, pixels; 0: no shadows.
var shadow_pixels: int = 4096
## How soft the edges of shadows are.
var shadow_filter: RenderingServer.ShadowQuality = RenderingServer.SHADOW_QUALITY_SOFT_LOW
## Share of a world's distance of shadows.
var shadow_reach: float = 1.0
## Share of the stones and bushes, and of the distance from which they are seen.
var scatter: float = 1.0
## Share of the particles of all effects: [member EffectBudget.share].
var particles: float = 1.0
## How many times all particles may fill the picture: [member EffectBudget.screens].
var overdraw: float = 6.0
## Most pixels along an edge of a picture, where a processor draws.
var texture_pixels: int = 1024


## For who draws with the processor.
static func low() -> QualityTier:
	var tier: QualityTier = QualityTier.new()
	tier.name = "low"
	tier.render_scale = 0.5
	tier.anisotropy = Viewport.ANISOTROPY_DISABLED
	tier.lod_pixels = 4.0
	tier.shadow_pixels = 0
	tier.scatter = 0.4
	tier.particles = 0.5
	tier.overdraw = 2.0
	tier.texture_pixels = 512
	return tier


## For graphics that share the processor's memory.
static func medium() -> QualityTier:
	var tier: QualityTier = QualityTier.new()
	tier.name = "medium"
	tier.render_scale = 0.77
	tier.anisotropy = Viewport.ANISOTROPY_2X
	tier.lod_pixels = 2.0
	tier.shadow_pixels = 2048
	tier.shadow_filter = RenderingServer.SHADOW_QUALITY_HARD
	tier.shadow_reach = 0.7
	tier.scatter = 0.7
	tier.particles = 0.75
	tier.overdraw = 4.0
	return tier


## For a graphics card.
static func high() -> QualityTier:
	var tier: QualityTier = QualityTier.new()
	tier.name = "high"
	return tier


## For a fast one: edges are smooth.
static func ultra() -> QualityTier:
	var tier: QualityTier = QualityTier.new()
	tier.name = "ultra"
	tier.msaa = Viewport.MSAA_4X
	tier.anisotropy = Viewport.ANISOTROPY_16X
	tier.lod_pixels = 0.5
	tier.overdraw = 10.0
	tier.shadow_pixels = 8192
	tier.shadow_filter = RenderingServer.SHADOW_QUALITY_SOFT_MEDIUM
	return tier
