// SPDX-License-Identifier: MIT
#pragma once

#include "../src/receipt_window.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>

namespace godot {

/// What one end has not taken in yet. Documented in doc_classes/ReceiptWindow.xml.
class ReceiptWindow : public RefCounted {
	GDCLASS(ReceiptWindow, RefCounted)

public:
	PackedByteArray note_sent(int64_t p_bytes);
	void take_receipt(const PackedByteArray &p_nonce);
	int64_t get_unreceipted() const;
	bool is_exceeded() const;

protected:
	static void _bind_methods();

private:
	transport::ReceiptWindow _core;
};

} // namespace godot
