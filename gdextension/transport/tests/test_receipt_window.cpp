// SPDX-License-Identifier: MIT
#include "check.hpp"
#include "receipt_window.hpp"

#include <set>
#include <vector>

namespace test_receipt_window {

using transport::ReceiptWindow;

TEST(a_probe_follows_every_64_kib) {
	ReceiptWindow window;
	std::vector<ReceiptWindow::Nonce> probes;
	for (int i = 0; i < 1000; i++) {
		ReceiptWindow::Nonce probe{};
		if (window.note_sent(1000, probe)) {
			probes.push_back(probe);
		}
	}
	// Of 66 packets each: the 66th reaches 65536 bytes.
	CHECK(probes.size() == 15);
	CHECK(std::set<ReceiptWindow::Nonce>(probes.begin(), probes.end()).size() == 15);
	CHECK(window.unreceipted() == 1000000);
	window.take_receipt(probes.back());
	CHECK(window.unreceipted() == 10000);
}

TEST(a_receipt_stands_for_all_before_it_and_counts_once) {
	ReceiptWindow window;
	std::vector<ReceiptWindow::Nonce> probes(4);
	for (ReceiptWindow::Nonce &probe : probes) {
		CHECK(window.note_sent(100000, probe));
	}
	window.take_receipt(probes[1]);
	CHECK(window.unreceipted() == 200000);
	window.take_receipt(probes[1]);
	window.take_receipt(probes[0]);
	CHECK(window.unreceipted() == 200000);
	window.take_receipt(probes[3]);
	CHECK(window.unreceipted() == 0);
}

TEST(made_up_receipts_are_ignored) {
	ReceiptWindow window;
	ReceiptWindow::Nonce probe{};
	CHECK(window.note_sent(70000, probe));
	window.take_receipt({});
	probe[3] ^= 1;
	window.take_receipt(probe);
	CHECK(window.unreceipted() == 70000);
}

TEST(the_window_has_an_end) {
	ReceiptWindow window;
	ReceiptWindow::Nonce probe{};
	window.note_sent(ReceiptWindow::MAX_UNRECEIPTED, probe);
	CHECK(!window.is_exceeded());
	window.note_sent(1, probe);
	CHECK(window.is_exceeded());
}

} // namespace test_receipt_window
