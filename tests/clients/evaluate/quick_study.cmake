# Runs PROGRAM STUDY --quick FLAGS into the empty folder OUT; fails unless it ends with 0 and leaves the files LEAVES and PICTURE
# there.
file(REMOVE_RECURSE ${OUT})
execute_process(COMMAND ${PROGRAM} ${STUDY} --quick ${FLAGS} --out ${OUT} RESULT_VARIABLE ended OUTPUT_VARIABLE said ERROR_VARIABLE told)
if(NOT ended EQUAL 0 OR NOT EXISTS ${OUT}/${LEAVES} OR NOT EXISTS ${OUT}/${PICTURE})
  message(FATAL_ERROR "it ended with ${ended}:\n${said}${told}")
endif()
file(REMOVE_RECURSE ${OUT})
