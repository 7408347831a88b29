find_package(Skein 0.1 REQUIRED COMPONENTS levitation)
