// SPDX-License-Identifier: MIT
#include "receipt_window.hpp"

#include <algorithm>

namespace godot {

PackedByteArray ReceiptWindow::note_sent(int64_t p_bytes) {
	ERR_FAIL_COND_V_MSG(p_bytes < 0, PackedByteArray(), "A packet has no negative size.");
	PackedByteArray bytes;
	transport::ReceiptWindow::Nonce nonce{};
	if (_core.note_sent(p_bytes, nonce)) {
		bytes.resize(int64_t(nonce.size()));
		std::copy(nonce.begin(), nonce.end(), bytes.ptrw());
	}
	return bytes;
}

void ReceiptWindow::take_receipt(const PackedByteArray &p_nonce) {
	transport::ReceiptWindow::Nonce nonce{};
	// It comes from the network: what has another size was never asked for.
	if (p_nonce.size() == int64_t(nonce.size())) {
		std::copy_n(p_nonce.ptr(), nonce.size(), nonce.begin());
		_core.take_receipt(nonce);
	}
}

int64_t ReceiptWindow::get_unreceipted() const {
	return _core.unreceipted();
}

bool ReceiptWindow::is_exceeded() const {
	return _core.is_exceeded();
}

void ReceiptWindow::_bind_methods() {
	ClassDB::bind_method(D_METHOD("note_sent", "bytes"), &ReceiptWindow::note_sent);
	ClassDB::bind_method(D_METHOD("take_receipt", "nonce"), &ReceiptWindow::take_receipt);
	ClassDB::bind_method(D_METHOD("get_unreceipted"), &ReceiptWindow::get_unreceipted);
	ClassDB::bind_method(D_METHOD("is_exceeded"), &ReceiptWindow::is_exceeded);
}

} // namespace godot
