// SPDX-License-Identifier: MIT
// The test vectors of draft-irtf-cfrg-cpace, "Test vector for CPace using group ristretto255 and hash
// SHA-512", and of its appendix on strings.
#include "check.hpp"
#include "hex.hpp"
#include "sealing/cpace.hpp"

namespace test_cpace {

using namespace transport;

namespace {

Bytes ascii(const std::string &p_text) {
	return { p_text.begin(), p_text.end() };
}

const Bytes PASSWORD = ascii("Password");
const Bytes CHANNEL = hex("0b415f696e69746961746f720b425f726573706f6e646572");
const Bytes SESSION = hex("7e4b4791d6a8ef019b936c79fb7f2c57");
const cpace::Inputs INPUTS{ PASSWORD, CHANNEL, SESSION };
const auto YA = hex_array<32>("da3d23700a9e5699258aef94dc060dfda5ebb61f02a5ea77fad53f4ff0976d08");
const auto YB = hex_array<32>("d2316b454718c35362d83d69df6320f38578ed5984651435e2949762d900b80d");
const auto SHARE_A = hex_array<32>("d6bac480f2c386c394efc7c47adb9925dcd2630b64f240c50f8d0eec482b9157");
const auto SHARE_B = hex_array<32>("3ea7e0b19560d7c0b0f5734f63b955286dfa8232b5ebe63324e2d9e7433f7258");
const Bytes ADA = ascii("ADa");
const Bytes ADB = ascii("ADb");

} // namespace

TEST(strings_get_their_length_as_in_the_draft) {
	Bytes made;
	cpace::append_with_length(made, View());
	cpace::append_with_length(made, ascii("1234"));
	CHECK(equal(made, hex("000431323334")));
	Bytes long_one(128);
	for (size_t i = 0; i < long_one.size(); i++) {
		long_one[i] = uint8_t(i);
	}
	made.clear();
	cpace::append_with_length(made, View(long_one.data(), 127));
	CHECK(made.size() == 128 && made[0] == 0x7F);
	made.clear();
	cpace::append_with_length(made, long_one);
	CHECK(made.size() == 130 && made[0] == 0x80 && made[1] == 0x01 && made[129] == 0x7F);
}

TEST(the_generator_is_that_of_the_draft) {
	CHECK(equal(cpace::generator_string(INPUTS),
			hex("11435061636552697374726574746f3235350850617373776f726464" + std::string(200, '0') +
					"180b415f696e69746961746f720b425f726573706f6e646572107e4b4791d6a8ef019b936c79fb7f2c57")));
	CHECK(equal(cpace::generator(INPUTS), hex("222b6b195fe84b1652badb6f6a3ae3d24341e7306967f0b8115b40d5698c7e56")));
}

TEST(a_long_password_needs_no_padding) {
	const Bytes password(200, 'x');
	const Bytes text = cpace::generator_string({ password, CHANNEL, SESSION });
	CHECK(text.size() == 18 + 202 + 1 + 25 + 17);
	CHECK(text[18] == 0xC8 && text[19] == 0x01 && text[220] == 0);
}

TEST(shares_are_those_of_the_draft) {
	const auto generator = cpace::generator(INPUTS);
	CHECK(cpace::share_of(YA, generator) == SHARE_A);
	CHECK(cpace::share_of(YB, generator) == SHARE_B);
}

TEST(both_ends_get_the_session_key_of_the_draft) {
	const auto expected = hex_array<64>("b69effbf61b51d56401c0f65601abe428de8206feaaf0e32198896dcae7b35cd"
										"2b38950a39dfd5d4a79164614c2984f7daa460b588c1e80c3fa2068af7900447");
	CHECK(cpace::session_key(YA, SHARE_B, SESSION, { SHARE_A, ADA }, { SHARE_B, ADB }) == expected);
	CHECK(cpace::session_key(YB, SHARE_A, SESSION, { SHARE_A, ADA }, { SHARE_B, ADB }) == expected);
}

TEST(scalars_multiply_as_in_the_draft) {
	const auto scalar = hex_array<32>("7cd0e075fa7955ba52c02759a6c90dbbfc10e6d40aea8d283e407d88cf538a05");
	const auto point = hex_array<32>("2c3c6b8c4f3800e7aef6864025b4ed79bd599117e427c41bd47d93d654b4a51c");
	CHECK(cpace::share_of(scalar, point) ==
			hex_array<32>("7c13645fe790a468f62c39beb7388e541d8405d1ade69d1778c5fe3e7f6b600e"));
}

TEST(invalid_shares_of_the_draft_end_the_exchange) {
	const auto scalar = hex_array<32>("7cd0e075fa7955ba52c02759a6c90dbbfc10e6d40aea8d283e407d88cf538a05");
	for (const std::string &digits :
			{ std::string("2b3c6b8c4f3800e7aef6864025b4ed79bd599117e427c41bd47d93d654b4a51c"), std::string(64, '0') }) {
		const auto share = hex_array<32>(digits);
		CHECK(!cpace::share_of(scalar, share));
		CHECK(!cpace::session_key(scalar, share, SESSION, { SHARE_A, ADA }, { share, ADB }));
	}
}

TEST(another_password_session_or_associated_data_makes_another_key) {
	const Bytes other = ascii("password");
	const auto key_of = [](const View &p_a, const View &p_b, const View &p_session_a, const View &p_ada) {
		const auto ga = cpace::generator({ p_a, CHANNEL, p_session_a });
		const auto gb = cpace::generator({ p_b, CHANNEL, SESSION });
		const auto ya = cpace::sample_scalar();
		const auto yb = cpace::sample_scalar();
		const auto a = *cpace::share_of(ya, ga);
		const auto b = *cpace::share_of(yb, gb);
		const auto of_a = cpace::session_key(ya, b, p_session_a, { a, p_ada }, { b, ADB });
		const auto of_b = cpace::session_key(yb, a, SESSION, { a, ADA }, { b, ADB });
		return of_a && of_b && *of_a == *of_b;
	};
	CHECK(key_of(PASSWORD, PASSWORD, SESSION, ADA));
	CHECK(key_of(View(), View(), SESSION, ADA));
	CHECK(!key_of(PASSWORD, other, SESSION, ADA));
	CHECK(!key_of(PASSWORD, View(), SESSION, ADA));
	CHECK(!key_of(PASSWORD, PASSWORD, CHANNEL, ADA));
	CHECK(!key_of(PASSWORD, PASSWORD, SESSION, ADB));
}

} // namespace test_cpace
