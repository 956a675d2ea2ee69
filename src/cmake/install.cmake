include(CMakePackageConfigHelpers)

set(osculo_targets osculo_core osculo_lib)
if(OSCULO_BUILD_IO)
  list(APPEND osculo_targets osculo_presets osculo_io)
endif()
install(TARGETS ${osculo_targets} EXPORT osculo-targets)
if(OSCULO_BUILD_CLI)
  install(TARGETS osculo_cli)
endif()
install(DIRECTORY include/osculo DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT osculo-targets NAMESPACE osculo:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculo)
configure_package_config_file(src/cmake/osculo-config.cmake.in osculo-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculo)
write_basic_package_version_file(osculo-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/osculo-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/osculo-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/osculo)
