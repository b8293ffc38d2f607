@abstract class_name PanelSheet
extends PanelContainer
## A sheet over the [DevicePanel], which shows one at a time.

## It is to be closed.
@warning_ignore("unused_signal")
signal close_wanted

## Gives the keyboard to what is used first.
@abstract func focus_first() -> void
