class_name ClientInteraction
extends ClientPart
## Lets the user use what is looked at or pointed at, and shows what the key would do.

var _interaction: Interaction = Interaction.new()


func _ready() -> void:
	add_child(_interaction)


func begin() -> String:
	_interaction.prompt_changed.connect(context.hud.show_prompt)
	_interaction.use_by_name(context.options.text("use"))
	if context.is_headset_worn():
		_interaction.aim = context.headset.aim
	return ""


## What is in a level that is still on its way cannot be used yet.
func advance(_delta_s: float) -> void:
	_interaction.set_process(context.scene.replica.is_ready())
