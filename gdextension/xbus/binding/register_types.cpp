// SPDX-License-Identifier: MIT
#include "mvn_encoder.hpp"
#include "mvn_receiver.hpp"
#include "raw_player.hpp"
#include "raw_recorder.hpp"
#include "stream_time.hpp"
#include "suit_device.hpp"
#include "suit_frame.hpp"
#include "suit_hub.hpp"
#include "suit_message.hpp"
#include "suit_tracker.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(SuitTracker);
		GDREGISTER_CLASS(SuitDevice);
		GDREGISTER_CLASS(SuitFrame);
		GDREGISTER_CLASS(SuitMessage);
		GDREGISTER_CLASS(RawRecorder);
		GDREGISTER_CLASS(RawPlayer);
		GDREGISTER_CLASS(MvnEncoder);
		GDREGISTER_CLASS(MvnReceiver);
		GDREGISTER_CLASS(SuitHub);
		GDREGISTER_CLASS(StreamTime);
	}
}

void terminate(ModuleInitializationLevel) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT xbus_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
