#!/bin/sh
# What CMake has compilers started by: through ccache where $DISMOUNT_CCACHE names one. As it is always this script, a
# ccache that comes or goes changes no command of the build and so builds nothing anew.
exec ${DISMOUNT_CCACHE:+"$DISMOUNT_CCACHE"} "$@"
