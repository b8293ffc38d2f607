class_name ClientInteraction
extends ClientPart
## Lets the user use what is looked at or pointed at, and shows what the key would do.


func begin() -> String:
	var interaction: Interaction = Interaction.new()
	add_child(interaction)
	interaction.prompt_changed.connect(context.hud.show_prompt)
	interaction.use_by_name(context.options.text("use"))
	if context.is_headset_worn():
		interaction.aim = context.headset.aim
	return ""
