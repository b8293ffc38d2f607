// SPDX-License-Identifier: MIT
#include "discovery_answer.hpp"
#include "discovery_port.hpp"
#include "fast_packet.hpp"
#include "receipt_window.hpp"
#include "sealed_socket.hpp"
#include "transport_pump.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(DiscoveryAnswer);
		GDREGISTER_CLASS(DiscoveryPort);
		GDREGISTER_CLASS(FastPacket);
		GDREGISTER_CLASS(ReceiptWindow);
		GDREGISTER_CLASS(SealedSocket);
		GDREGISTER_CLASS(TransportPump);
	}
}

void terminate(ModuleInitializationLevel) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT transport_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
