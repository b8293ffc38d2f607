// SPDX-License-Identifier: MIT
#include "suit_message.hpp"

#include "text.hpp"

namespace godot {

static_assert(SuitMessage::SEVERITY_ERROR == int(xbus::Severity::ERROR), "The severities are not a session's.");

Ref<SuitMessage> SuitMessage::make(const usb::HubMessage &p_message) {
	Ref<SuitMessage> message;
	message.instantiate();
	message->_severity = Severity(p_message.severity);
	message->_text = as_string(p_message.text);
	return message;
}

void SuitMessage::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_severity"), &SuitMessage::get_severity);
	ClassDB::bind_method(D_METHOD("get_text"), &SuitMessage::get_text);
	BIND_ENUM_CONSTANT(SEVERITY_INFO);
	BIND_ENUM_CONSTANT(SEVERITY_WARNING);
	BIND_ENUM_CONSTANT(SEVERITY_ERROR);
}

} // namespace godot
