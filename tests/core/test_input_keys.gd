extends TestCase
## Names of keys on buttons.


func test_a_button_names_the_key_of_its_action() -> void:
	equal(InputKeys.label("Accept", &"accept_calibration"), "Accept [F9]")
	equal(InputKeys.label("Use", &"interact"), "Use [E]")


func test_an_action_without_a_key_has_only_its_text() -> void:
	InputMap.add_action(&"no_key")
	equal(InputKeys.label("Nothing", &"no_key"), "Nothing")
	InputMap.erase_action(&"no_key")
