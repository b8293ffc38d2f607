// SPDX-License-Identifier: MIT
#pragma once

#include <usb/hub.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// One line for the log. Documented in doc_classes/SuitMessage.xml.
class SuitMessage : public RefCounted {
	GDCLASS(SuitMessage, RefCounted)

public:
	/// In the order of `xbus::Severity`.
	enum Severity {
		SEVERITY_INFO,
		SEVERITY_WARNING,
		SEVERITY_ERROR,
	};

	static Ref<SuitMessage> make(const usb::HubMessage &p_message);

	Severity get_severity() const { return _severity; }
	String get_text() const { return _text; }

protected:
	static void _bind_methods();

private:
	Severity _severity = SEVERITY_INFO;
	String _text;
};

} // namespace godot

VARIANT_ENUM_CAST(SuitMessage::Severity);
