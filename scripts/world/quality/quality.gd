@tool
class_name Quality
extends RefCounted
## How much is drawn, in tiers: which one is used now, and which one fits a machine.
##
## What has to know joins the group [constant FOLLOWERS] and has a method
## [code]follow_quality()[/code], which reads [member tier].

## Names of the tiers, from the one that costs least.
const NAMES: Array[String] = ["low", "medium", "high", "ultra"]
## Group of the nodes that follow a change.
const FOLLOWERS: StringName = &"quality_followers"
## What programs that draw with the processor call their device.
const _SOFTWARE: Array[String] = ["llvmpipe", "softpipe", "lavapipe", "swiftshader", "basic render"]
## What the names of graphics cards have, where the renderer does not know the kind of device.
const _CARDS: Array[String] = ["nvidia", "geforce", "quadro", "radeon rx", "radeon pro", "arc a"]

## The tier that is used: the whole picture where nobody has chosen, as in tools and tests.
static var tier: QualityTier = QualityTier.high()


## The tier of a name; of none that there is, the one called high.
static func find(p_name: String) -> QualityTier:
	match p_name:
		"low":
			return QualityTier.low()
		"medium":
			return QualityTier.medium()
		"ultra":
			return QualityTier.ultra()
	return QualityTier.high()


## Name of the tier that fits a device, by its name and its kind.
static func fitting(p_adapter: String, p_type: RenderingDevice.DeviceType) -> String:
	if is_software(p_adapter, p_type):
		return "low"
	if p_type == RenderingDevice.DEVICE_TYPE_DISCRETE_GPU:
		return "high"
	for card: String in _CARDS:
		if p_adapter.to_lower().contains(card):
			return "high"
	return "medium"


## Whether a processor draws.
static func is_software(p_adapter: String, p_type: RenderingDevice.DeviceType) -> bool:
	if p_type == RenderingDevice.DEVICE_TYPE_CPU:
		return true
	for name: String in _SOFTWARE:
		if p_adapter.to_lower().contains(name):
			return true
	return false


## Whether this machine's processor draws.
static func draws_by_processor() -> bool:
	return is_software(
		RenderingServer.get_video_adapter_name(), RenderingServer.get_video_adapter_type()
	)


## Uses a tier from now on, in a window and everything that it shows.
static func use(p_tier: QualityTier, p_window: Viewport) -> void:
	tier = p_tier
	EffectBudget.share = tier.particles
	EffectBudget.screens = tier.overdraw
	p_window.scaling_3d_scale = tier.render_scale
	p_window.msaa_3d = tier.msaa
	p_window.anisotropic_filtering_level = tier.anisotropy
	p_window.mesh_lod_threshold = tier.lod_pixels
	RenderingServer.directional_shadow_atlas_set_size(maxi(tier.shadow_pixels, 256), true)
	RenderingServer.directional_soft_shadow_filter_set_quality(tier.shadow_filter)
	if p_window.is_inside_tree():
		p_window.get_tree().call_group(FOLLOWERS, &"follow_quality")
