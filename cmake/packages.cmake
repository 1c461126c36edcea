# What is installed, and as which Debian package: a component each. deploy/package builds them.
include(GNUInstallDirs)
set(WEFT_PACKAGER "Weft maintainers <weft@packages.invalid>" CACHE STRING "Maintainer of the Debian packages, NAME <ADDRESS>")
set(templates ${PROJECT_SOURCE_DIR}/deploy/packages)
set(units ${PROJECT_SOURCE_DIR}/deploy/systemd)
set(made ${PROJECT_BINARY_DIR}/packages)

# Libraries that are compiled in, by headers alone: their licences go with each package.
set(licences "")
foreach(library libboost1.74-dev libcli11-dev libeigen3-dev libexpected-dev libfastcdr-dev libspdlog-dev libtomlplusplus-dev
    nlohmann-json3-dev)
  if(EXISTS /usr/share/doc/${library}/copyright)
    file(READ /usr/share/doc/${library}/copyright text)
    string(APPEND licences "==== ${library}\n\n${text}\n")
  endif()
endforeach()
file(WRITE ${made}/headers "${licences}")
configure_file(${templates}/changelog ${made}/changelog @ONLY)
foreach(text headers changelog)
  execute_process(COMMAND gzip -9nc ${made}/${text} OUTPUT_FILE ${made}/${text}.gz COMMAND_ERROR_IS_FATAL ANY)
endforeach()

set(CPACK_COMPONENTS_ALL "")

# weft_package(NAME SUMMARY TEXT [PROGRAM TARGET] [DEPENDS ...] [RECOMMENDS ...] [SECTION ...]): component and package NAME.
function(weft_package name summary text)
  cmake_parse_arguments(PACKAGE "" "PROGRAM;DEPENDS;RECOMMENDS;SECTION" "" ${ARGN})
  string(TOUPPER ${name} key)
  if(PACKAGE_PROGRAM)
    install(TARGETS ${PACKAGE_PROGRAM} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT ${name})
    set(CPACK_DEBIAN_${key}_PACKAGE_SHLIBDEPS ON PARENT_SCOPE)
    install(FILES ${made}/headers.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${name})
  else()
    set(CPACK_DEBIAN_${key}_PACKAGE_ARCHITECTURE all PARENT_SCOPE)
  endif()
  if(NOT PACKAGE_SECTION)
    set(PACKAGE_SECTION misc)
  endif()
  install(FILES ${templates}/copyright ${made}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${name})
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${PACKAGE_SECTION} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${PACKAGE_DEPENDS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_RECOMMENDS "${PACKAGE_RECOMMENDS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${text}" PARENT_SCOPE)
endfunction()

# weft_maintain(PACKAGE UNITS UNITS ENABLED PATHS STATE TEXT [AFTER_UPGRADE COMMAND] [CONFFILES PATH...]): its maintainer scripts.
function(weft_maintain PACKAGE)
  cmake_parse_arguments(PARSE_ARGV 1 "" "" "UNITS;ENABLED;STATE;AFTER_UPGRADE" "CONFFILES")
  foreach(word UNITS ENABLED STATE AFTER_UPGRADE)
    set(${word} "${_${word}}")
  endforeach()
  if(NOT AFTER_UPGRADE)
    set(AFTER_UPGRADE ":")
  endif()
  set(scripts "")
  foreach(script postinst prerm postrm)
    configure_file(${templates}/${script}.in ${made}/${PACKAGE}/${script} @ONLY)
    list(APPEND scripts ${made}/${PACKAGE}/${script})
  endforeach()
  if(_CONFFILES)
    list(JOIN _CONFFILES "\n" conffiles)
    file(WRITE ${made}/${PACKAGE}/conffiles "${conffiles}\n")
    list(APPEND scripts ${made}/${PACKAGE}/conffiles)
  endif()
  install(FILES ${units}/weft.sysusers DESTINATION lib/sysusers.d RENAME ${PACKAGE}.conf COMPONENT ${PACKAGE})
  install(FILES ${units}/${PACKAGE}.tmpfiles DESTINATION lib/tmpfiles.d RENAME ${PACKAGE}.conf COMPONENT ${PACKAGE})
  string(TOUPPER ${PACKAGE} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_CONTROL_EXTRA "${scripts}" PARENT_SCOPE)
endfunction()

set(makes_users "systemd | systemd-standalone-sysusers, systemd | systemd-standalone-tmpfiles")
weft_package(weft-server "fleet map server of Weft"
  "Keeps the network of places that all robots of a site share, and leads\ntheir goals. With a daily backup of the map."
  PROGRAM weft-server DEPENDS "${makes_users}, weft-cli (= ${PROJECT_VERSION}), weft-health (= ${PROJECT_VERSION})" RECOMMENDS weft-doc SECTION net)
weft_maintain(weft-server UNITS "weft-backup.timer weft-backup.service weft-server.service"
  ENABLED "\"$root/etc/systemd/system/multi-user.target.wants/weft-server.service\" \"$root/etc/systemd/system/timers.target.wants/weft-backup.timer\""
  STATE "the map" AFTER_UPGRADE "if [ -n \"$2\" ]; then systemctl try-restart weft-server.service; fi"
  CONFFILES /etc/weft/server.toml /etc/weft/backup.conf)
install(FILES ${templates}/server.toml ${templates}/backup.conf DESTINATION /etc/weft COMPONENT weft-server)
install(FILES ${units}/weft-server.service ${units}/weft-backup.service ${units}/weft-backup.timer
  DESTINATION /lib/systemd/system COMPONENT weft-server)
install(PROGRAMS ${templates}/backup DESTINATION lib/weft COMPONENT weft-server)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/deploy/monitoring ${PROJECT_SOURCE_DIR}/deploy/network
  DESTINATION ${CMAKE_INSTALL_DATADIR}/weft COMPONENT weft-server)

weft_package(weft-agent "agent of a robot of Weft"
  "Sees, localises, drives, and shares what it learns with weft-server.\nOne process a robot."
  PROGRAM weft-agent DEPENDS "${makes_users}, weft-health (= ${PROJECT_VERSION})" RECOMMENDS weft-cli SECTION net)
# An upgrade restarts no agent: its robot may be under way.
weft_maintain(weft-agent UNITS "'weft-agent@*.service'"
  ENABLED "\"$root\"/etc/systemd/system/multi-user.target.wants/weft-agent@*.service"
  STATE "what robots have not handed in")
install(DIRECTORY DESTINATION /etc/weft/agents COMPONENT weft-agent)
install(FILES ${templates}/agent.toml DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/weft-agent/examples COMPONENT weft-agent)
install(FILES ${units}/weft-agent@.service DESTINATION /lib/systemd/system COMPONENT weft-agent)

weft_package(weft-agent-sim "agent of a simulated robot of Weft"
  "As weft-agent, with a robot, cameras and a warehouse that are\nsimulated. For trying Weft, and for tests." PROGRAM weft-agent-sim SECTION net)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/deploy/sites DESTINATION ${CMAKE_INSTALL_DATADIR}/weft COMPONENT weft-agent-sim)

weft_package(weft-health "health probe of Weft"
  "Says within a twentieth of a second whether the server or agent whose\nfolder it is given works." PROGRAM weft-health SECTION net)

weft_package(weft-cli "operator's command of Weft"
  "Teaches robots, sends goals, and looks after map and fleet; talks to\nweft-server." PROGRAM weft RECOMMENDS weft-doc SECTION net)

weft_package(weft-doc "documentation of Weft"
  "How to operate and extend Weft; its formats, messages and decisions." SECTION doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/weft-doc COMPONENT weft-doc)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/weft-doc COMPONENT weft-doc)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME weft)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_VENDOR Weft)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_PREFIX /usr)
set(CPACK_SET_DESTDIR ON)  # some files are installed outside of the prefix, and never into this machine
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${WEFT_PACKAGER}")
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
